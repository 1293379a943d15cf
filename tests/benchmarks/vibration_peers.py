"""Compare vibration with pyYeti and FLife in one run: spectra of response, damage of spectra.

Run by hand, in an environment of its own: pip install pyyeti FLife, then
python tests/benchmarks/vibration_peers.py
"""

import response_spectra_peers
import spectral_fatigue

if __name__ == "__main__":
    response_spectra_peers.main()
    spectral_fatigue.main()

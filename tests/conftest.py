"""What all tests share: helpers beside this file can be imported, no deadlines, the same examples.

Property tests take the same random examples on every machine and in every run;
``--hypothesis-profile free`` takes new ones each time.
"""

import os

from hypothesis import settings

# the tests are spread over the cores already; no array here is worth two threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

settings.register_profile("free", deadline=None)
settings.register_profile("pinned", deadline=None, derandomize=True)
settings.load_profile("pinned")

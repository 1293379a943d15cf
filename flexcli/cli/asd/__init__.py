"""``flexure asd``: vibration profiles, and what they do to oscillators and designs."""

from flexcli.cli.asd import environments, profiles
from flexcli.cli.asd.common import app

__all__ = ["app", "environments", "profiles"]

"""Both parsers of PyYAML, for tests that must hold with either."""

import pytest
import yaml

from flexcli.spec import parse

LOADERS = [yaml.SafeLoader, *([yaml.CSafeLoader] if yaml.__with_libyaml__ else [])]


@pytest.fixture(params=LOADERS, ids=lambda loader: loader.__name__)
def either_parser(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run a test with libyaml's parser and with the one in Python that stands in for it."""
    monkeypatch.setattr(parse, "_SafeLoader", request.param)

"""What all tests share: helpers beside this file can be imported, and no deadlines."""

from hypothesis import settings

settings.register_profile("flexcli", deadline=None)
settings.load_profile("flexcli")

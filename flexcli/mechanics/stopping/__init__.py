"""A blade that vibrates between end stops: exact between contacts, event by event."""

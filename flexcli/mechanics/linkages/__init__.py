"""Linkages of rigid links: their motion from the assembled pose, and what their joints reflect."""

"""How the effects and the model of a design are planned, and audited."""

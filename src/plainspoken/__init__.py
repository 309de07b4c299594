"""plainspoken: tell a robot in plain words what should get done, and ask it how it is going."""

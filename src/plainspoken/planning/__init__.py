"""From a non-deterministic domain and a formula to a policy, or to the reason why there is none."""

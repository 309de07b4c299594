"""From an utterance to a grounded formula: refer, lift, ground."""

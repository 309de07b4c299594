"""Workers: processes that carry out the missions of a store, and take over from each other."""

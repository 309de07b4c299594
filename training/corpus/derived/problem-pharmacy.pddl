(define (problem pharmacy-1)
  (:domain pharmacy)
  (:objects
    rx-bot - robot
    loading-bay waiting-room - place
    aspirin insulin - medicine
    vial1 vial2 - vial)
  (:init (robot-at rx-bot counter) (hand-free rx-bot)
    (item-at aspirin storeroom) (item-at insulin storeroom)
    (item-at vial1 loading-bay) (item-at vial2 loading-bay)
    (connected counter storeroom) (connected storeroom counter)
    (connected storeroom loading-bay) (connected loading-bay storeroom)
    (connected counter waiting-room) (connected waiting-room counter))
  (:goal (item-at aspirin counter)))

(define (problem hotel-morning)
  (:domain hotel)
  (:objects
    rosie max - robot
    lobby kitchen suite laundry - place
    towel tray flowers suitcase - item)
  (:init
    (at rosie lobby) (at max kitchen)
    (free rosie) (free max)
    (lies towel laundry) (lies tray kitchen) (lies flowers lobby) (lies suitcase lobby)
    (unlocked lobby) (unlocked kitchen) (unlocked laundry)
    (dirty suite) (dirty kitchen)
    (linked lobby kitchen) (linked kitchen lobby)
    (linked lobby suite) (linked suite lobby)
    (linked kitchen laundry) (linked laundry kitchen)
    (linked laundry suite) (linked suite laundry))
  (:goal (and (lies flowers suite))))

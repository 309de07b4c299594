; One soup of onion, carrot and milk. The pantry has no door; the milk is behind the fridge's.
(define (problem one-soup)
  (:domain kitchen)
  (:objects
    rob - robot
    pantry fridge - store
    sink - sink
    counter - counter
    stove - stove
    table - table
    onion carrot - vegetable
    milk - ingredient
    soup - dish)
  (:init
    (robot-at rob counter) (hand-empty rob)
    (open pantry) (has-door fridge)
    (kept-in onion pantry) (kept-in carrot pantry) (kept-in milk fridge)
    (ready milk))
  (:goal (and (served soup) (not (stove-on)) (not (open fridge))))
)

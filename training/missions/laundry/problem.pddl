(define (problem morning) (:domain laundry)
  (:objects lola - robot basement lobby floor-1 floor-2 - place sheets towels tablecloths - bag
    washer dryer - machine)
  (:init (robot-at lola lobby) (corridor lobby basement) (corridor basement lobby)
    (corridor lobby floor-1) (corridor floor-1 lobby) (corridor floor-1 floor-2)
    (corridor floor-2 floor-1) (lies-at sheets floor-2) (lies-at towels floor-1)
    (lies-at tablecloths lobby) (stands-at washer basement) (stands-at dryer basement)
    (dirty sheets) (dirty towels) (dirty tablecloths) (hands-free lola))
  (:goal (and (shelved sheets) (shelved towels))))

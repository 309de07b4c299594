(define (domain greenhouse)
  (:requirements :strips :typing :non-deterministic)
  (:types place plant)
  (:predicates
    (robot-at ?l - place)
    (plant-in ?p - plant ?l - place)
    (carrying-plant ?p - plant)
    (hands-free)
    (needs-water ?p - plant)
    (door-open ?l - place)
    (door-shut ?l - place)
    (path-between ?a - place ?b - place))
  (:action drive-to
    :parameters (?a - place ?b - place)
    :precondition (and (robot-at ?a) (path-between ?a ?b) (door-open ?b))
    :effect (and (not (robot-at ?a)) (robot-at ?b)))
  (:action pick-up-plant
    :parameters (?p - plant ?l - place)
    :precondition (and (robot-at ?l) (plant-in ?p ?l) (hands-free))
    :effect (oneof
      (and (carrying-plant ?p) (not (plant-in ?p ?l)) (not (hands-free)))
      (and (plant-in ?p ?l) (hands-free))))
  (:action put-down-plant
    :parameters (?p - plant ?l - place)
    :precondition (and (robot-at ?l) (carrying-plant ?p))
    :effect (and (plant-in ?p ?l) (hands-free) (not (carrying-plant ?p))))
  (:action water-plant
    :parameters (?p - plant)
    :precondition (and (carrying-plant ?p))
    :effect (oneof
      (and (not (needs-water ?p)))
      (and (carrying-plant ?p))))
  (:action open-door
    :parameters (?l - place)
    :precondition (and (door-shut ?l))
    :effect (oneof
      (and (door-open ?l) (not (door-shut ?l)))
      (and (door-shut ?l))))
  (:action close-door
    :parameters (?l - place)
    :precondition (and (door-open ?l))
    :effect (and (door-shut ?l) (not (door-open ?l)))))

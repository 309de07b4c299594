(define (domain pharmacy)
  (:requirements :strips :typing :non-deterministic)
  (:types robot place item - object
          medicine vial - item)
  (:constants counter storeroom - place)
  (:predicates
    (robot-at ?r - robot ?p - place)
    (item-at ?i - item ?p - place)
    (carrying ?r - robot ?i - item)
    (hand-free ?r - robot)
    (connected ?a - place ?b - place)
    (fridge-open)
    (label-printed ?m - medicine)
    (vial-broken ?v - vial))
  (:action move-to
    :parameters (?r - robot ?a - place ?b - place)
    :precondition (and (robot-at ?r ?a) (connected ?a ?b))
    :effect (and (robot-at ?r ?b) (not (robot-at ?r ?a))))
  (:action pick-up
    :parameters (?r - robot ?i - item ?p - place)
    :precondition (and (robot-at ?r ?p) (item-at ?i ?p) (hand-free ?r))
    :effect (and (carrying ?r ?i) (not (item-at ?i ?p)) (not (hand-free ?r))))
  (:action put-down
    :parameters (?r - robot ?i - item ?p - place)
    :precondition (and (robot-at ?r ?p) (carrying ?r ?i))
    :effect (and (item-at ?i ?p) (not (carrying ?r ?i)) (hand-free ?r)))
  (:action open-fridge
    :parameters (?r - robot)
    :precondition (robot-at ?r storeroom)
    :effect (fridge-open))
  (:action close-fridge
    :parameters (?r - robot)
    :precondition (and (robot-at ?r storeroom) (fridge-open))
    :effect (not (fridge-open)))
  (:action print-label
    :parameters (?r - robot ?m - medicine)
    :precondition (robot-at ?r counter)
    :effect (oneof (label-printed ?m) (and)))
  (:action shake-vial
    :parameters (?r - robot ?v - vial)
    :precondition (carrying ?r ?v)
    :effect (oneof (and) (vial-broken ?v))))

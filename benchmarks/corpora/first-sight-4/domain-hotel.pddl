(define (domain hotel)
  (:requirements :strips :typing :non-deterministic)
  (:types robot place item)
  (:predicates
    (at ?r - robot ?p - place)
    (lies ?i - item ?p - place)
    (holding ?r - robot ?i - item)
    (free ?r - robot)
    (dirty ?p - place)
    (unlocked ?p - place)
    (linked ?a - place ?b - place))
  (:action move
    :parameters (?r - robot ?a - place ?b - place)
    :precondition (and (at ?r ?a) (linked ?a ?b) (unlocked ?b))
    :effect (and (not (at ?r ?a)) (at ?r ?b)))
  (:action grab
    :parameters (?r - robot ?i - item ?p - place)
    :precondition (and (at ?r ?p) (lies ?i ?p) (free ?r))
    :effect (oneof
      (and (holding ?r ?i) (not (lies ?i ?p)) (not (free ?r)))
      (and (lies ?i ?p) (free ?r))))
  (:action drop
    :parameters (?r - robot ?i - item ?p - place)
    :precondition (and (at ?r ?p) (holding ?r ?i))
    :effect (oneof
      (and (lies ?i ?p) (free ?r) (not (holding ?r ?i)))
      (and (lies ?i ?p) (free ?r) (not (holding ?r ?i)) (dirty ?p))))
  (:action clean
    :parameters (?r - robot ?p - place)
    :precondition (and (at ?r ?p) (free ?r))
    :effect (oneof
      (and (not (dirty ?p)))
      (and (free ?r))))
  (:action unlock
    :parameters (?r - robot ?p - place)
    :precondition (and (free ?r))
    :effect (and (unlocked ?p)))
  (:action lock
    :parameters (?r - robot ?p - place)
    :precondition (and (free ?r) (unlocked ?p))
    :effect (and (not (unlocked ?p)))))

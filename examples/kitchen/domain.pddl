; Making a soup in the kitchen of a small restaurant.
;
; One robot fetches, washes and chops the vegetables, adds everything to the pot, cooks the soup
; and serves it. Washing may splash, and nothing is served across a wet floor, so the robot mops.
; After tasting, the robot finds the soup seasoned or bland, or it cannot tell; then a person, the
; head cook, tastes it and says which it is. A bland soup gets salt. Cooking may boil over; then
; the stove goes out by itself, and has to be turned on again.
(define (domain kitchen)
  (:requirements :strips :typing :negative-preconditions :universal-preconditions
                 :non-deterministic)

  (:types
    robot place ingredient dish - object
    vegetable - ingredient
    store sink counter stove table - place)

  (:predicates
    (robot-at ?r - robot ?p - place)
    (kept-in ?i - ingredient ?s - store)
    (has-door ?s - store)
    (open ?s - store)
    (hand-empty ?r - robot)
    (holding ?i - ingredient)
    (washed ?v - vegetable)
    (chopped ?v - vegetable)
    ; true of what goes into the pot as it is
    (ready ?i - ingredient)
    (in-pot ?i - ingredient)
    (stove-on)
    (floor-wet)
    ; how far a dish is: cooked, then of one of three tastes, then served
    (cooked ?d - dish)
    (doubtful ?d - dish)
    (bland ?d - dish)
    (seasoned ?d - dish)
    (served ?d - dish))

  (:action go
    :parameters (?r - robot ?from ?to - place)
    :precondition (and (robot-at ?r ?from) (not (robot-at ?r ?to)))
    :effect (and (not (robot-at ?r ?from)) (robot-at ?r ?to)))

  (:action open-door
    :parameters (?r - robot ?s - store)
    :precondition (and (robot-at ?r ?s) (has-door ?s) (not (open ?s)))
    :effect (open ?s))

  (:action close-door
    :parameters (?r - robot ?s - store)
    :precondition (and (robot-at ?r ?s) (has-door ?s) (open ?s))
    :effect (not (open ?s)))

  (:action fetch
    :parameters (?r - robot ?i - ingredient ?s - store)
    :precondition (and (robot-at ?r ?s) (open ?s) (kept-in ?i ?s) (hand-empty ?r))
    :effect (and (not (kept-in ?i ?s)) (not (hand-empty ?r)) (holding ?i)))

  (:action wash
    :parameters (?r - robot ?v - vegetable ?s - sink)
    :precondition (and (robot-at ?r ?s) (holding ?v) (not (washed ?v)))
    :effect (and (washed ?v)
                 (oneof (floor-wet) (and))))

  (:action mop
    :parameters (?r - robot ?s - sink)
    :precondition (and (robot-at ?r ?s) (floor-wet))
    :effect (not (floor-wet)))

  (:action chop
    :parameters (?r - robot ?v - vegetable ?c - counter)
    :precondition (and (robot-at ?r ?c) (holding ?v) (washed ?v) (not (chopped ?v)))
    :effect (and (chopped ?v) (ready ?v)))

  (:action add
    :parameters (?r - robot ?i - ingredient ?s - stove)
    :precondition (and (robot-at ?r ?s) (holding ?i) (ready ?i))
    :effect (and (not (holding ?i)) (hand-empty ?r) (in-pot ?i)))

  (:action turn-on
    :parameters (?r - robot ?s - stove)
    :precondition (and (robot-at ?r ?s) (not (stove-on)))
    :effect (stove-on))

  (:action turn-off
    :parameters (?r - robot ?s - stove)
    :precondition (and (robot-at ?r ?s) (stove-on))
    :effect (not (stove-on)))

  (:action cook
    :parameters (?r - robot ?d - dish ?s - stove)
    :precondition (and (robot-at ?r ?s) (stove-on) (not (cooked ?d))
                       (forall (?i - ingredient) (in-pot ?i)))
    :effect (oneof (cooked ?d) (not (stove-on))))

  (:action taste
    :parameters (?r - robot ?d - dish ?s - stove)
    :precondition (and (robot-at ?r ?s) (cooked ?d)
                       (not (doubtful ?d)) (not (bland ?d)) (not (seasoned ?d)))
    :effect (oneof (seasoned ?d) (bland ?d) (doubtful ?d)))

  ; The exception: the robot cannot tell, so the head cook does.
  (:action ask-cook
    :parameters (?r - robot ?d - dish ?s - stove)
    :precondition (and (robot-at ?r ?s) (doubtful ?d))
    :effect (and (not (doubtful ?d))
                 (oneof (seasoned ?d) (bland ?d))))

  (:action add-salt
    :parameters (?r - robot ?d - dish ?s - stove)
    :precondition (and (robot-at ?r ?s) (bland ?d))
    :effect (and (not (bland ?d)) (seasoned ?d)))

  (:action serve
    :parameters (?r - robot ?d - dish ?t - table)
    :precondition (and (robot-at ?r ?t) (seasoned ?d) (not (served ?d))
                       (hand-empty ?r) (not (floor-wet)))
    :effect (served ?d))
)

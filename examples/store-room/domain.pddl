; A robot fetches parcels. Doors may be locked and parcels in one room or another: nobody says.
(define (domain store-room)
  (:requirements :strips :typing)
  (:types robot room parcel)
  (:predicates
    (at ?r - robot ?p - room)
    (joined ?p ?q - room)
    (locked ?p - room)
    (in ?x - parcel ?p - room)
    (has ?r - robot ?x - parcel)
    (free ?r - robot)
    (full ?p - room))
  (:action go
    :parameters (?r - robot ?from ?to - room)
    :precondition (and (at ?r ?from) (joined ?from ?to) (not (locked ?to)))
    :effect (and (at ?r ?to) (not (at ?r ?from))))
  (:action unlock
    :parameters (?r - robot ?p ?q - room)
    :precondition (and (at ?r ?p) (joined ?p ?q) (locked ?q))
    :effect (not (locked ?q)))
  (:action take
    :parameters (?r - robot ?x - parcel ?p - room)
    :precondition (and (at ?r ?p) (in ?x ?p) (free ?r))
    :effect (and (has ?r ?x) (not (in ?x ?p)) (not (free ?r))))
  (:action put
    :parameters (?r - robot ?x - parcel ?p - room)
    :precondition (and (at ?r ?p) (has ?r ?x) (not (full ?p)))
    :effect (and (in ?x ?p) (free ?r) (not (has ?r ?x))))
  (:action clear
    :parameters (?r - robot ?p - room)
    :precondition (and (at ?r ?p) (free ?r) (full ?p))
    :effect (not (full ?p))))

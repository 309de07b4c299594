(define (domain airport)
  (:requirements :strips :typing :non-deterministic)
  (:types cart loc parcel door)
  (:constants hangar - loc)
  (:predicates
    (at ?c - cart ?l - loc)
    (lies ?p - parcel ?l - loc)
    (holding ?c - cart ?p - parcel)
    (empty ?c - cart)
    (road ?a ?b - loc)
    (by ?d - door ?l - loc)
    (locked ?d - door)
    (scanned ?p - parcel)
    (delivered ?p - parcel)
    (plugged-in ?c - cart))
  (:action drive
    :parameters (?c - cart ?a ?b - loc)
    :precondition (and (at ?c ?a) (road ?a ?b))
    :effect (and (at ?c ?b) (not (at ?c ?a)) (not (plugged-in ?c))))
  (:action load
    :parameters (?c - cart ?p - parcel ?l - loc)
    :precondition (and (at ?c ?l) (lies ?p ?l) (empty ?c))
    :effect (oneof (and (holding ?c ?p) (not (lies ?p ?l)) (not (empty ?c))) (and)))
  (:action deliver-parcel
    :parameters (?c - cart ?p - parcel ?l - loc)
    :precondition (and (at ?c ?l) (holding ?c ?p))
    :effect (and (delivered ?p) (lies ?p ?l) (empty ?c) (not (holding ?c ?p))))
  (:action unlock-door
    :parameters (?c - cart ?d - door ?l - loc)
    :precondition (and (at ?c ?l) (by ?d ?l) (locked ?d))
    :effect (not (locked ?d)))
  (:action lock-door
    :parameters (?c - cart ?d - door ?l - loc)
    :precondition (and (at ?c ?l) (by ?d ?l))
    :effect (locked ?d))
  (:action scan
    :parameters (?c - cart ?p - parcel)
    :precondition (holding ?c ?p)
    :effect (oneof (scanned ?p) (and)))
  (:action recharge
    :parameters (?c - cart)
    :precondition (at ?c hangar)
    :effect (plugged-in ?c)))

; A robot carries samples and meals through a clinic, and looks after its rooms.
(define (domain clinic)
  (:requirements :strips :typing :negative-preconditions :non-deterministic)
  (:types
    robot room item - object
    sample meal - item
    ward lab pantry - room)
  (:predicates
    (robot-in ?r - robot ?p - room)
    (linked ?a ?b - room)
    (item-in ?i - item ?p - room)
    (carrying ?r - robot ?i - item)
    (tray-free ?r - robot)
    (untested ?s - sample)
    (positive ?s - sample)
    (negative ?s - sample)
    (locked ?p - room)
    (lights-on ?p - room)
    (disinfected ?p - ward)
    (served ?m - meal))
  (:action go
    :parameters (?r - robot ?from ?to - room)
    :precondition (and (robot-in ?r ?from) (linked ?from ?to) (not (locked ?to)))
    :effect (and (not (robot-in ?r ?from)) (robot-in ?r ?to)))
  (:action unlock
    :parameters (?r - robot ?from ?p - room)
    :precondition (and (robot-in ?r ?from) (linked ?from ?p) (locked ?p))
    :effect (not (locked ?p)))
  (:action pick-up
    :parameters (?r - robot ?i - item ?p - room)
    :precondition (and (robot-in ?r ?p) (item-in ?i ?p) (tray-free ?r))
    :effect (and (not (item-in ?i ?p)) (not (tray-free ?r)) (carrying ?r ?i)))
  (:action put-down
    :parameters (?r - robot ?i - item ?p - room)
    :precondition (and (robot-in ?r ?p) (carrying ?r ?i))
    :effect (and (not (carrying ?r ?i)) (tray-free ?r) (item-in ?i ?p)))
  (:action test-sample
    :parameters (?r - robot ?s - sample ?l - lab)
    :precondition (and (robot-in ?r ?l) (item-in ?s ?l) (untested ?s))
    :effect (and (not (untested ?s)) (oneof (positive ?s) (negative ?s))))
  (:action switch-on-lights
    :parameters (?r - robot ?p - room)
    :precondition (and (robot-in ?r ?p) (not (lights-on ?p)))
    :effect (lights-on ?p))
  (:action switch-off-lights
    :parameters (?r - robot ?p - room)
    :precondition (and (robot-in ?r ?p) (lights-on ?p))
    :effect (not (lights-on ?p)))
  (:action disinfect
    :parameters (?r - robot ?w - ward)
    :precondition (and (robot-in ?r ?w) (lights-on ?w))
    :effect (disinfected ?w))
  (:action serve-meal
    :parameters (?r - robot ?m - meal ?w - ward)
    :precondition (and (robot-in ?r ?w) (carrying ?r ?m))
    :effect (and (not (carrying ?r ?m)) (tray-free ?r) (served ?m)))
)

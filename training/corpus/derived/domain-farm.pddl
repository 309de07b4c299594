(define (domain farm)
  (:requirements :strips :typing :non-deterministic)
  (:types drone site - object
          plant sensor - object)
  (:constants pond barn - site)
  (:predicates
    (drone-at ?d - drone ?s - site)
    (grows ?p - plant ?s - site)
    (mounted ?x - sensor ?s - site)
    (watered ?p - plant)
    (photographed ?p - plant)
    (broken ?x - sensor)
    (tank-empty ?d - drone)
    (battery-low ?d - drone)
    (raining))
  (:action fly-to
    :parameters (?d - drone ?a ?b - site)
    :precondition (drone-at ?d ?a)
    :effect (and (drone-at ?d ?b) (not (drone-at ?d ?a)) (oneof (battery-low ?d) (and))))
  (:action water-plant
    :parameters (?d - drone ?p - plant ?s - site)
    :precondition (and (drone-at ?d ?s) (grows ?p ?s))
    :effect (and (watered ?p) (oneof (tank-empty ?d) (and))))
  (:action photograph
    :parameters (?d - drone ?p - plant ?s - site)
    :precondition (and (drone-at ?d ?s) (grows ?p ?s))
    :effect (photographed ?p))
  (:action repair-sensor
    :parameters (?d - drone ?x - sensor ?s - site)
    :precondition (and (drone-at ?d ?s) (mounted ?x ?s) (broken ?x))
    :effect (oneof (not (broken ?x)) (and)))
  (:action refill-tank
    :parameters (?d - drone)
    :precondition (drone-at ?d pond)
    :effect (not (tank-empty ?d)))
  (:action charge
    :parameters (?d - drone)
    :precondition (drone-at ?d barn)
    :effect (not (battery-low ?d))))

(define (domain theatre-stage)
  (:requirements :strips :typing :non-deterministic)
  (:types stagehand spot prop lamp)
  (:constants balcony left-wing trapdoor - spot)
  (:predicates
    (is-at ?s - stagehand ?p - spot)
    (prop-in ?x - prop ?p - spot)
    (has ?s - stagehand ?x - prop)
    (free ?s - stagehand)
    (lit ?l - lamp)
    (curtain-up)
    (fog-on)
    (adjacent ?a ?b - spot))
  (:action walk
    :parameters (?s - stagehand ?a ?b - spot)
    :precondition (and (is-at ?s ?a) (adjacent ?a ?b))
    :effect (and (is-at ?s ?b) (not (is-at ?s ?a))))
  (:action grab-prop
    :parameters (?s - stagehand ?x - prop ?p - spot)
    :precondition (and (is-at ?s ?p) (prop-in ?x ?p) (free ?s))
    :effect (and (has ?s ?x) (not (prop-in ?x ?p)) (not (free ?s))))
  (:action place-prop
    :parameters (?s - stagehand ?x - prop ?p - spot)
    :precondition (and (is-at ?s ?p) (has ?s ?x))
    :effect (and (prop-in ?x ?p) (free ?s) (not (has ?s ?x))))
  (:action switch-on
    :parameters (?s - stagehand ?l - lamp)
    :precondition (is-at ?s balcony)
    :effect (oneof (lit ?l) (and)))
  (:action switch-off
    :parameters (?s - stagehand ?l - lamp)
    :precondition (and (is-at ?s balcony) (lit ?l))
    :effect (not (lit ?l)))
  (:action raise-curtain
    :parameters (?s - stagehand)
    :precondition (is-at ?s left-wing)
    :effect (curtain-up))
  (:action start-fog
    :parameters (?s - stagehand)
    :precondition (is-at ?s trapdoor)
    :effect (oneof (fog-on) (and))))

(define (domain recycling-yard)
  (:requirements :strips :typing :non-deterministic)
  (:types sorter area bale container)
  (:constants press_hall entrance - area)
  (:predicates
    (sorter_at ?s - sorter ?a - area)
    (bale_at ?b - bale ?a - area)
    (gripping ?s - sorter ?b - bale)
    (gripper_empty ?s - sorter)
    (full ?c - container)
    (in_area ?c - container ?a - area)
    (gate_open)
    (press_running)
    (path ?a ?b - area))
  (:action go
    :parameters (?s - sorter ?a ?b - area)
    :precondition (and (sorter_at ?s ?a) (path ?a ?b))
    :effect (and (sorter_at ?s ?b) (not (sorter_at ?s ?a))))
  (:action lift_bale
    :parameters (?s - sorter ?b - bale ?a - area)
    :precondition (and (sorter_at ?s ?a) (bale_at ?b ?a) (gripper_empty ?s))
    :effect (oneof (and (gripping ?s ?b) (not (bale_at ?b ?a)) (not (gripper_empty ?s))) (and)))
  (:action drop_bale
    :parameters (?s - sorter ?b - bale ?a - area)
    :precondition (and (sorter_at ?s ?a) (gripping ?s ?b))
    :effect (and (bale_at ?b ?a) (gripper_empty ?s) (not (gripping ?s ?b))))
  (:action empty_container
    :parameters (?s - sorter ?c - container ?a - area)
    :precondition (and (sorter_at ?s ?a) (in_area ?c ?a) (full ?c))
    :effect (not (full ?c)))
  (:action start_press
    :parameters (?s - sorter)
    :precondition (sorter_at ?s press_hall)
    :effect (oneof (press_running) (and)))
  (:action stop_press
    :parameters (?s - sorter)
    :precondition (and (sorter_at ?s press_hall) (press_running))
    :effect (not (press_running)))
  (:action open_gate
    :parameters (?s - sorter)
    :precondition (sorter_at ?s entrance)
    :effect (gate_open)))

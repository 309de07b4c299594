; Harvesting table grapes in a trellis vineyard.
;
; A harvesting robot drives along the lines, checks each grape, picks the ripe ones and drops
; them in the box it carries. Bunches differ in size, so only after a drop does it know whether
; the box is full. A full box is emptied by the support robot, which comes when it is called -
; or is busy, and has to be called again - and then takes the load to the warehouse. A check
; may fail; then a person is called, looks at the grape, and says what it is.
(define (domain vineyard)
  (:requirements :strips :typing :negative-preconditions :universal-preconditions
                 :disjunctive-preconditions :conditional-effects :non-deterministic)

  (:types
    robot location grape box - object
    harvester support - robot
    line warehouse - location)

  (:predicates
    (robot-at ?r - robot ?l - location)
    (adjacent ?a ?b - location)
    (grape-at ?g - grape ?l - line)
    (carries ?h - harvester ?b - box)
    (hand-empty ?h - harvester)
    (in-hand ?g - grape)
    (inside ?g - grape ?b - box)
    (stored ?g - grape)
    (full ?b - box)
    ; what is known of a grape: exactly one of these four
    (unchecked ?g - grape)
    (unknown ?g - grape)
    (ripe ?g - grape)
    (unripe ?g - grape)
    (picked ?g - grape)
    (cleared ?l - line))

  (:action move
    :parameters (?h - harvester ?from ?to - location)
    :precondition (and (robot-at ?h ?from) (adjacent ?from ?to))
    :effect (and (not (robot-at ?h ?from)) (robot-at ?h ?to)))

  (:action check-grape
    :parameters (?h - harvester ?g - grape ?l - line)
    :precondition (and (robot-at ?h ?l) (grape-at ?g ?l) (unchecked ?g))
    :effect (and (not (unchecked ?g))
                 (oneof (ripe ?g) (unripe ?g) (unknown ?g))))

  ; The exception: the robot cannot tell, so a person decides.
  (:action ask-human
    :parameters (?h - harvester ?g - grape ?l - line)
    :precondition (and (robot-at ?h ?l) (grape-at ?g ?l) (unknown ?g))
    :effect (and (not (unknown ?g))
                 (oneof (ripe ?g) (unripe ?g))))

  (:action harvest-grape
    :parameters (?h - harvester ?g - grape ?l - line)
    :precondition (and (robot-at ?h ?l) (grape-at ?g ?l) (ripe ?g) (not (picked ?g))
                       (hand-empty ?h))
    :effect (and (picked ?g) (in-hand ?g) (not (hand-empty ?h))))

  (:action drop-grape
    :parameters (?h - harvester ?g - grape ?b - box)
    :precondition (and (carries ?h ?b) (in-hand ?g) (not (full ?b)))
    :effect (and (not (in-hand ?g)) (hand-empty ?h) (inside ?g ?b)
                 (oneof (full ?b) (and))))

  (:action call-support
    :parameters (?h - harvester ?s - support ?from ?to - location)
    :precondition (and (robot-at ?h ?to) (robot-at ?s ?from))
    :effect (oneof (and (not (robot-at ?s ?from)) (robot-at ?s ?to))
                   (and)))

  (:action empty-box
    :parameters (?h - harvester ?s - support ?b - box ?l - location ?w - warehouse)
    :precondition (and (carries ?h ?b) (robot-at ?h ?l) (robot-at ?s ?l))
    :effect (and (not (full ?b))
                 (forall (?g - grape)
                   (when (inside ?g ?b) (and (not (inside ?g ?b)) (stored ?g))))
                 (not (robot-at ?s ?l)) (robot-at ?s ?w)))

  ; A line is cleared when every grape on it is known to be unripe or has left it, hand included.
  (:action sign-off
    :parameters (?h - harvester ?l - line)
    :precondition (and (robot-at ?h ?l) (hand-empty ?h)
                       (forall (?g - grape)
                         (or (not (grape-at ?g ?l)) (unripe ?g) (picked ?g))))
    :effect (cleared ?l))
)

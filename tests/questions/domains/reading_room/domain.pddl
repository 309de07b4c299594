; A robot brings books back to their shelves in a reading room.
;
; A returned book is examined: it is fine, torn or somebody else's. A torn book is mended at the
; desk, where the glue may not hold at first. The lights may be off in the stacks, and a shelf
; may be blocked by a reader, who is asked to step aside.
(define (domain reading-room)
  (:requirements :strips :typing :negative-preconditions :non-deterministic)
  (:types robot place book - object
          shelf desk - place)
  (:predicates
    (robot-at ?r - robot ?p - place)
    (aisle ?a ?b - place)
    (belongs-on ?k - book ?s - shelf)
    (on-desk ?k - book)
    (on-trolley ?k - book)
    (shelved ?k - book)
    (examined ?k - book)
    (torn ?k - book)
    (mended ?k - book)
    (blocked ?s - shelf)
    (free ?s - shelf)
    (lights-on))
  (:action roll
    :parameters (?r - robot ?from ?to - place)
    :precondition (and (robot-at ?r ?from) (aisle ?from ?to))
    :effect (and (not (robot-at ?r ?from)) (robot-at ?r ?to)))
  (:action examine
    :parameters (?r - robot ?k - book ?d - desk)
    :precondition (and (robot-at ?r ?d) (on-desk ?k) (not (examined ?k)))
    :effect (and (examined ?k) (oneof (torn ?k) (and))))
  (:action mend
    :parameters (?r - robot ?k - book ?d - desk)
    :precondition (and (robot-at ?r ?d) (on-desk ?k) (torn ?k))
    :effect (oneof (and (not (torn ?k)) (mended ?k)) (and)))
  (:action load
    :parameters (?r - robot ?k - book ?d - desk)
    :precondition (and (robot-at ?r ?d) (on-desk ?k) (examined ?k) (not (torn ?k)))
    :effect (and (not (on-desk ?k)) (on-trolley ?k)))
  (:action switch-on
    :parameters (?r - robot ?d - desk)
    :precondition (and (robot-at ?r ?d) (not (lights-on)))
    :effect (lights-on))
  (:action inspect-shelf
    :parameters (?r - robot ?s - shelf)
    :precondition (and (robot-at ?r ?s) (lights-on) (not (blocked ?s)) (not (free ?s)))
    :effect (oneof (blocked ?s) (free ?s)))
  (:action ask-reader
    :parameters (?r - robot ?s - shelf)
    :precondition (and (robot-at ?r ?s) (blocked ?s))
    :effect (oneof (and (not (blocked ?s)) (free ?s)) (and)))
  (:action shelve
    :parameters (?r - robot ?k - book ?s - shelf)
    :precondition (and (robot-at ?r ?s) (on-trolley ?k) (belongs-on ?k ?s) (free ?s))
    :effect (and (not (on-trolley ?k)) (shelved ?k)))
)

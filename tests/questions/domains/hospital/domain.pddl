; A robot brings medicines from the pharmacy to the patients of a ward.
;
; A medicine may be out of stock; then it is ordered, and may not come at once. A patient who is
; asleep is woken, which may take several attempts, and a door may be locked until the nurse
; on duty has been called.
(define (domain hospital)
  (:requirements :strips :typing :negative-preconditions :non-deterministic)
  (:types robot place patient medicine - object
          room pharmacy station - place)
  (:predicates
    (robot-at ?r - robot ?p - place)
    (corridor ?a ?b - place)
    (lies-in ?x - patient ?p - room)
    (prescribed ?m - medicine ?x - patient)
    (on-tray ?m - medicine)
    (out-of-stock ?m - medicine)
    (given ?m - medicine ?x - patient)
    (unseen ?x - patient)
    (awake ?x - patient)
    (asleep ?x - patient)
    (charted ?x - patient)
    (nurse-informed))
  (:action walk
    :parameters (?r - robot ?from ?to - place)
    :precondition (and (robot-at ?r ?from) (corridor ?from ?to))
    :effect (and (not (robot-at ?r ?from)) (robot-at ?r ?to)))
  (:action collect
    :parameters (?r - robot ?m - medicine ?p - pharmacy)
    :precondition (and (robot-at ?r ?p) (not (on-tray ?m)) (not (out-of-stock ?m)))
    :effect (oneof (on-tray ?m) (out-of-stock ?m)))
  (:action order
    :parameters (?r - robot ?m - medicine ?p - pharmacy)
    :precondition (and (robot-at ?r ?p) (out-of-stock ?m))
    :effect (oneof (and (not (out-of-stock ?m)) (on-tray ?m)) (and)))
  (:action look-at
    :parameters (?r - robot ?x - patient ?p - room)
    :precondition (and (robot-at ?r ?p) (lies-in ?x ?p) (unseen ?x))
    :effect (and (not (unseen ?x)) (oneof (awake ?x) (asleep ?x))))
  (:action wake
    :parameters (?r - robot ?x - patient ?p - room)
    :precondition (and (robot-at ?r ?p) (lies-in ?x ?p) (asleep ?x))
    :effect (oneof (and (not (asleep ?x)) (awake ?x)) (and)))
  (:action give
    :parameters (?r - robot ?m - medicine ?x - patient ?p - room)
    :precondition (and (robot-at ?r ?p) (lies-in ?x ?p) (prescribed ?m ?x) (on-tray ?m) (awake ?x))
    :effect (and (not (on-tray ?m)) (given ?m ?x)))
  (:action chart
    :parameters (?r - robot ?m - medicine ?x - patient ?p - room)
    :precondition (and (robot-at ?r ?p) (lies-in ?x ?p) (given ?m ?x) (not (charted ?x)))
    :effect (charted ?x))
  (:action inform-nurse
    :parameters (?r - robot ?p - station)
    :precondition (robot-at ?r ?p)
    :effect (nurse-informed))
)

; Parcels from the high shelves to the loading dock of a warehouse.
;
; Two robots share the work. The forklift drives into an aisle and lowers a parcel to the floor;
; the cart comes to load it, scans its label, and unloads it at the dock. Two things go wrong. A
; parcel may jam on the shelf: then a worker is called to pull it free, who may be busy and has to
; be called again. And a label may be unreadable: then the cart takes the parcel to the office,
; where the clerk types the number in, and may find the parcel damaged; it is repacked there.
; Unloading is heavy work, so after it the cart's battery may be low; it drives on, but loads
; nothing more before it has been charged.
(define (domain warehouse)
  (:requirements :strips :typing :negative-preconditions :non-deterministic)

  (:types
    robot place parcel - object
    carrier lifter - robot
    aisle dock office charger - place)

  (:predicates
    (robot-at ?r - robot ?p - place)
    (path ?a ?b - place)
    (battery-low ?c - carrier)
    ; where a parcel is: exactly one of these five
    (on-shelf ?x - parcel ?a - aisle)
    (jammed ?x - parcel ?a - aisle)
    (on-floor ?x - parcel ?a - aisle)
    (on-cart ?x - parcel)
    (delivered ?x - parcel)
    ; what is known of its label: nothing at first, then one of these two
    (scanned ?x - parcel)
    (unreadable ?x - parcel)
    ; what the clerk found, until it is repacked
    (damaged ?x - parcel))

  (:action drive
    :parameters (?r - robot ?from ?to - place)
    :precondition (and (robot-at ?r ?from) (path ?from ?to))
    :effect (and (not (robot-at ?r ?from)) (robot-at ?r ?to)))

  (:action lower-parcel
    :parameters (?f - lifter ?x - parcel ?a - aisle)
    :precondition (and (robot-at ?f ?a) (on-shelf ?x ?a))
    :effect (and (not (on-shelf ?x ?a))
                 (oneof (on-floor ?x ?a) (jammed ?x ?a))))

  ; The first exception: a worker pulls the parcel free, or is busy.
  (:action call-worker
    :parameters (?f - lifter ?x - parcel ?a - aisle)
    :precondition (and (robot-at ?f ?a) (jammed ?x ?a))
    :effect (oneof (and (not (jammed ?x ?a)) (on-floor ?x ?a))
                   (and)))

  (:action load-parcel
    :parameters (?c - carrier ?x - parcel ?a - aisle)
    :precondition (and (robot-at ?c ?a) (on-floor ?x ?a) (not (battery-low ?c)))
    :effect (and (not (on-floor ?x ?a)) (on-cart ?x)))

  (:action scan-parcel
    :parameters (?c - carrier ?x - parcel)
    :precondition (and (on-cart ?x) (not (scanned ?x)) (not (unreadable ?x)))
    :effect (oneof (scanned ?x) (unreadable ?x)))

  ; The second exception: the clerk knows the parcel, and says whether it has to be repacked.
  (:action ask-clerk
    :parameters (?c - carrier ?x - parcel ?o - office)
    :precondition (and (robot-at ?c ?o) (on-cart ?x) (unreadable ?x))
    :effect (and (not (unreadable ?x)) (scanned ?x)
                 (oneof (damaged ?x) (and))))

  (:action repack-parcel
    :parameters (?c - carrier ?x - parcel ?o - office)
    :precondition (and (robot-at ?c ?o) (on-cart ?x) (damaged ?x))
    :effect (not (damaged ?x)))

  (:action unload-parcel
    :parameters (?c - carrier ?x - parcel ?d - dock)
    :precondition (and (robot-at ?c ?d) (on-cart ?x) (scanned ?x)
                       (not (damaged ?x)))
    :effect (and (not (on-cart ?x)) (delivered ?x)
                 (oneof (battery-low ?c) (and))))

  (:action charge
    :parameters (?c - carrier ?p - charger)
    :precondition (robot-at ?c ?p)
    :effect (not (battery-low ?c)))
)

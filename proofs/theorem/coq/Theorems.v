(** The two theorems, the tie to the source, and what all of it rests on. *)

From Coq Require Import ZArith Reals.
From NCP Require Import Kernel Doubles Ball Inside Step Horizon Clock Motion Governed Witness Liveness Tie Exported.

(** The tie holds for the doubles: their indices are bounded. *)
Definition inside_is_the_source := @inside_is_the_model doubles.
Definition ask_is_the_source {Q : Sequence} :=
  @plant_following_ask_3_is_the_model doubles Q double_index_bounded.

Print following.
Check governed_plant_stays_within.
Check plant_moves_only_when_allowed.

(* From here on, check.sh reads each name. *)
Print Assumptions governed_plant_stays_within.
Print Assumptions limited_plant_stays_within.
Print Assumptions excursion_simply.
Print Assumptions some_plant_follows.
Print Assumptions outlier_outside.
Print Assumptions plant_moves_only_when_allowed.
Print Assumptions latch_stays.
Print Assumptions hold_persists.
Print Assumptions inside_is_the_source.
Print Assumptions ask_is_the_source.

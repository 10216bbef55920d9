(** A horizon of any length, followed exactly: each place on the way lies inside but for the roundings. *)

From Coq Require Import ZArith Reals Psatz Bool Arith.
From Flocq Require Import Core BinarySingleNaN.
From NCP Require Import Kernel Doubles Ball Inside Step.

Open Scope R_scope.

(** The ttl that plant and projection enforce; 0 for one that is no time. *)
Definition enforced (p : plan doubles) : num doubles :=
  match enforced_ttl_ms (ttl_ms p) with Some ttl => ttl | None => zero end.

(** The velocity of a tick, in m/s. *)
Definition velocity_of (p : plan doubles) (tick : nat) : point :=
  match velocity p tick with Some v => place v | None => (0, 0, 0) end.

(** Where an exact plant is at the start of a tick: each tick before has been followed for its exact share. *)
Fixpoint start_of (p : plan doubles) (position : point) (dt t : R) (tick : nat) : point :=
  match tick with
  | O => position
  | Datatypes.S k => moved (start_of p position dt t k) (velocity_of p k) (share k dt t)
  end.

Lemma enforced_val : forall p, finite (enforced p) = true /\ 0 <= val (enforced p) <= 60000.
Proof.
  intros p. unfold enforced, enforced_ttl_ms.
  destruct zero_val as (Fz & Z). destruct max_ttl_val as (Fm & M).
  destruct (is_duration (ttl_ms p)) eqn:D; cbn [negb].
  - unfold is_duration in D. apply andb_prop in D as (F & P). apply (lt_val zero _ Fz F) in P. rewrite Z in P.
    destruct (lt (ttl_ms p) max_ttl_ms) eqn:L.
    + apply (lt_val _ _ F Fm) in L. rewrite M in L. split; [exact F|lra].
    + rewrite M. split; [exact Fm|lra].
  - rewrite Z. split; [exact Fz|lra].
Qed.

Lemma share_bounds : forall k dt t, 0 <= t -> 0 < dt -> 0 <= share k dt t.
Proof. intros. unfold share. apply Rmax_l. Qed.

Lemma keep_more : forall (velocities : nat -> option (vec doubles)) dt ttl radius more at_ kept,
  (kept <= keep velocities dt ttl radius at_ kept more)%nat.
Proof.
  intros velocities dt ttl radius more. induction more as [|more IH]; intros at_ kept; cbn [keep]; [lia|].
  destruct (velocities (Datatypes.S kept)) as [v|]; [|lia].
  destruct (after at_ v (tick_share_ms (Datatypes.S kept) dt ttl) radius) as [e|]; [|lia].
  specialize (IH e (Datatypes.S kept)). lia.
Qed.

(** What the kernel has computed of the steps that it keeps. *)
Lemma keep_exact : forall (p : plan doubles) (dt radius : num doubles) (position : point) (b : R) more at_ kept d,
  let ttl := enforced p in
  let n := keep (velocity p) dt ttl radius at_ kept more in
  let error := step_error (val radius) b (val ttl) in
  finite dt = true -> 0 < val dt -> (Z.of_nat (kept + more) <= 2 ^ 53)%Z ->
  near (start_of p position (val dt) (val ttl) (Datatypes.S kept)) (place at_) d ->
  far (place at_) <= val radius * (1 + 3 * u) + delta ->
  (forall k, (k <= n)%nat -> slow (velocity_of p k) b) ->
  (kept <= n <= kept + more)%nat /\
  forall j, (kept <= j <= n)%nat ->
    far (start_of p position (val dt) (val ttl) (Datatypes.S j))
      <= val radius * (1 + 3 * u) + delta + 2 * (d + INR (j - kept) * error).
Proof.
  intros p dt radius position b more. induction more as [|more IH]; intros at_ kept d ttl n error Fd Pd Hk Hn Hf Hs.
  - simpl in n. unfold n. split; [lia|]. intros j Hj. replace j with kept by lia. rewrite Nat.sub_diag. simpl INR.
    rewrite Rmult_0_l, Rplus_0_r. apply far_near with (place at_); [exact Hf|now apply near_sym].
  - assert (Base : forall j, j = kept -> far (start_of p position (val dt) (val ttl) (Datatypes.S j))
      <= val radius * (1 + 3 * u) + delta + 2 * (d + INR (j - kept) * error)).
    { intros j ->. rewrite Nat.sub_diag. simpl INR. rewrite Rmult_0_l, Rplus_0_r.
      apply far_near with (place at_); [exact Hf|now apply near_sym]. }
    unfold n in *. cbn [keep] in *. destruct (velocity p (Datatypes.S kept)) as [v|] eqn:V.
    2: { split; [lia|]. intros j Hj. apply Base. lia. }
    destruct (after at_ v (tick_share_ms (Datatypes.S kept) dt ttl) radius) as [e|] eqn:A.
    2: { split; [lia|]. intros j Hj. apply Base. lia. }
    assert (Ve : velocity_of p (Datatypes.S kept) = place v) by (unfold velocity_of; now rewrite V).
    set (rest := keep (velocity p) dt ttl radius e (Datatypes.S kept) more) in *.
    destruct (enforced_val p) as (Ft & Ht). fold ttl in Ft, Ht.
    assert (Sl : slow (place v) b) by (rewrite <- Ve; apply Hs; apply Nat.le_trans with (Datatypes.S kept); [lia|apply keep_more]).
    destruct (share_error (Datatypes.S kept) dt ttl ltac:(lia) Fd Pd Ft Ht) as (P & E).
    destruct (after_exact at_ v e _ radius _ b (val ttl) A Sl P E) as (Fe & Ne).
    assert (Near : near (start_of p position (val dt) (val ttl) (Datatypes.S (Datatypes.S kept))) (place e) (d + error)).
    { change (start_of p position (val dt) (val ttl) (Datatypes.S (Datatypes.S kept))) with
        (moved (start_of p position (val dt) (val ttl) (Datatypes.S kept)) (velocity_of p (Datatypes.S kept))
          (share (Datatypes.S kept) (val dt) (val ttl))). rewrite Ve.
      eapply near_trans; [|exact Ne]. now apply moved_near. }
    destruct (IH e (Datatypes.S kept) (d + error) Fd Pd ltac:(lia) Near Fe Hs) as (B & C).
    fold ttl in B, C. fold rest in B, C. fold error in C.
    split; [lia|]. intros j Hj. destruct (Nat.eq_dec j kept) as [J|J]; [now apply Base|].
    specialize (C j ltac:(lia)).
    replace (j - kept)%nat with (Datatypes.S (j - Datatypes.S kept)) by lia. rewrite S_INR.
    eapply Rle_trans; [exact C|]. right. ring.
Qed.

(** (c) A horizon: the start and the end of each tick that is kept. *)
Theorem horizon_exact : forall (p : plan doubles) (position : vec doubles) (dt radius : num doubles) (b : R) (n : nat),
  inside position radius = true -> steps_inside p position radius = Ok n -> (0 < n)%nat ->
  dt_ms p = Some dt -> is_duration dt = true -> (Z.of_nat (steps p) <= 2 ^ 53)%Z ->
  (forall k, (k <= n)%nat -> slow (velocity_of p k) b) ->
  let t := val (enforced p) in
  (n <= steps p)%nat /\
  forall j, (j <= Datatypes.S n)%nat ->
    far (start_of p (place position) (val dt) t j)
      <= val radius * (1 + 3 * u) + delta + 2 * (INR j * step_error (val radius) b t).
Proof.
  intros p position dt radius b n Hi Hs Hn Hdt Hd Hsteps Hv t.
  assert (D : finite dt = true /\ 0 < val dt).
  { unfold is_duration in Hd. apply andb_prop in Hd as (F & P). destruct zero_val as (Fz & Z).
    apply (lt_val zero _ Fz F) in P. rewrite Z in P. auto. }
  destruct D as (Fd & Pd). destruct (enforced_val p) as (Ft & Ht).
  unfold steps_inside in Hs. fold (enforced p) in Hs. cbv zeta in Hs. rewrite Hdt in Hs.
  destruct (velocity p 0) as [v|] eqn:V; [|discriminate].
  assert (Ve : velocity_of p 0 = place v) by (unfold velocity_of; now rewrite V).
  destruct (Nat.eqb_spec (steps p) 0) as [S0|S0].
  { destruct (after position v (enforced p) radius); [|discriminate]. injection Hs as <-. lia. }
  destruct (after position v (tick_share_ms 0 dt (enforced p)) radius) as [e|] eqn:A; [|discriminate].
  destruct (Nat.eqb_spec (keep (velocity p) dt (enforced p) radius e 0 (steps p)) 0) as [K|K].
  { destruct (after position v (enforced p) radius); [|discriminate]. injection Hs as <-. lia. }
  injection Hs as Hs.
  assert (Sl : slow (place v) b) by (rewrite <- Ve; apply Hv; lia).
  destruct (share_error 0 dt (enforced p) ltac:(simpl; lia) Fd Pd Ft Ht) as (P & E).
  destruct (after_exact position v e _ radius _ b t A Sl P E) as (Fe & Ne).
  pose proof (keep_exact p dt radius (place position) b (steps p) e 0 (step_error (val radius) b t)) as C.
  cbv zeta in C. rewrite Hs in C.
  destruct C as (C1 & C2); try assumption; try lia.
  { change (start_of p (place position) (val dt) (val (enforced p)) 1) with
      (moved (place position) (velocity_of p 0) (share 0 (val dt) t)). now rewrite Ve. }
  split; [lia|]. intros [|j] Hj.
  - simpl. destruct (inside_exact position radius Hi) as (R0 & R1).
    rewrite Rmult_0_l, Rmult_0_r, Rplus_0_r. exact R1.
  - specialize (C2 j ltac:(lia)). rewrite Nat.sub_0_r in C2. eapply Rle_trans; [exact C2|].
    rewrite S_INR. fold t. right. ring.
Qed.

(** Without a horizon, tick 0 is followed for all of the ttl. *)
Theorem alone_exact : forall (p : plan doubles) (position : vec doubles) (radius : num doubles) (b : R),
  steps_inside p position radius = Ok 0%nat -> slow (velocity_of p 0) b ->
  let t := val (enforced p) in
  far (moved (place position) (velocity_of p 0) t)
    <= val radius * (1 + 3 * u) + delta + 2 * step_error (val radius) b t.
Proof.
  intros p position radius b Hs Hv t. destruct (enforced_val p) as (Ft & Ht). fold t in Ht.
  unfold steps_inside in Hs. fold (enforced p) in Hs. cbv zeta in Hs.
  destruct (velocity p 0) as [v|] eqn:V; [|discriminate].
  assert (Ve : velocity_of p 0 = place v) by (unfold velocity_of; now rewrite V). rewrite Ve in *.
  assert (A : exists e, after position v (enforced p) radius = Some e).
  { destruct (after position v (enforced p) radius) as [e|]; [now exists e|exfalso].
    destruct (Nat.eqb (steps p) 0); [discriminate|].
    set (dt := match dt_ms p with Some dt => dt | None => not_a_number end) in *.
    destruct (after position v (tick_share_ms 0 dt (enforced p)) radius) as [e|]; [|discriminate].
    destruct (Nat.eqb_spec (keep (velocity p) dt (enforced p) radius e 0 (steps p)) 0); [discriminate|]. congruence. }
  destruct A as (e & A).
  assert (E : Rabs (val (enforced p) - t) <= 3 * u * t + 3 * tiny).
  { unfold t. rewrite Rminus_eq_0, Rabs_R0. pose proof u_pos. pose proof tiny_pos. fold t.
    assert (0 <= u * t) by (apply Rmult_le_pos; lra). lra. }
  destruct (after_exact position v e (enforced p) radius t b t A Hv ltac:(fold t; lra) E) as (Fe & Ne).
  apply far_near with (place e); [exact Fe|now apply near_sym].
Qed.

(** The ball is convex: on the way through a tick, an exact plant is no further out than at the tick's two ends. *)
Theorem way_exact : forall (p : plan doubles) (position : point) (dt t age b : R) (k : nat), 0 < dt ->
  INR k * dt <= age <= INR (Datatypes.S k) * dt -> age <= t ->
  far (start_of p position dt t k) <= b -> far (start_of p position dt t (Datatypes.S k)) <= b ->
  far (moved (start_of p position dt t k) (velocity_of p k) (age - INR k * dt)) <= b.
Proof.
  intros p position dt t age b k Hd (H0 & H1) Ht Hk Hk'. rewrite S_INR in H1.
  cbn [start_of] in Hk'. set (s := share k dt t) in *.
  assert (Hs : age - INR k * dt <= s).
  { unfold s, share. apply Rle_trans with (Rmin dt (t - INR k * dt)); [|apply Rmax_r]. apply Rmin_glb; lra. }
  destruct (Rle_lt_dec (age - INR k * dt) 0) as [Z|Z].
  - replace (age - INR k * dt) with 0 by lra. now rewrite moved_0.
  - rewrite (moved_between _ _ _ s) by lra. apply ball_convex; [|assumption|assumption].
    split; [apply Rlt_le, Rdiv_lt_0_compat; lra|]. apply Rmult_le_reg_r with s; [lra|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.

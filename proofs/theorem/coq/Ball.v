(** Balls about the origin in exact real numbers. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.

Open Scope R_scope.

(** A point or a velocity of space. *)
Definition point : Type := R * R * R.

Definition square (p : point) : R := let '(x, y, z) := p in x * x + y * y + z * z.

(** Its exact distance from the origin. *)
Definition far (p : point) : R := sqrt (square p).

Lemma square_nonneg : forall p, 0 <= square p.
Proof. intros ((x, y), z). simpl. nra. Qed.

Lemma far_nonneg : forall p, 0 <= far p.
Proof. intros p. apply sqrt_pos. Qed.

Lemma far_le : forall p b, 0 <= b -> square p <= b * b -> far p <= b.
Proof. intros p b Hb H. unfold far. rewrite <- (sqrt_square b Hb). now apply sqrt_le_1_alt. Qed.

Lemma le_far : forall p b, far p <= b -> square p <= b * b.
Proof.
  intros p b H. pose proof (far_nonneg p). pose proof (square_nonneg p).
  rewrite <- (sqrt_sqrt (square p)) by assumption. change (sqrt (square p)) with (far p). nra.
Qed.

Lemma component_le_far : forall x y z b, far (x, y, z) <= b -> Rabs x <= b /\ Rabs y <= b /\ Rabs z <= b.
Proof.
  intros x y z b H. pose proof (far_nonneg (x, y, z)). apply le_far in H as S. simpl in S.
  repeat split; apply Rabs_le; split; nra.
Qed.

(** A part, from 0 to 1, of the way from one point to another. *)
Definition between (p q : point) (part : R) : point :=
  let '(x, y, z) := p in
  let '(u, v, w) := q in
  (x + part * (u - x), y + part * (v - y), z + part * (w - z)).

Lemma ball_convex : forall p q part b, 0 <= part <= 1 -> far p <= b -> far q <= b -> far (between p q part) <= b.
Proof.
  intros ((x, y), z) ((u, v), w) t b Ht Hp Hq. pose proof (far_nonneg (x, y, z)).
  apply far_le; [lra|]. apply le_far in Hp. apply le_far in Hq. simpl in *.
  assert (C : forall a c, (a + t * (c - a)) * (a + t * (c - a)) <= (1 - t) * (a * a) + t * (c * c)).
  { intros a c. assert (0 <= t * (1 - t) * ((a - c) * (a - c))).
    { apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rle_0_sqr]. }
    nra. }
  pose proof (C x u). pose proof (C y v). pose proof (C z w). nra.
Qed.

(** No component of [q] is further than [d] from that of [p]. *)
Definition near (p q : point) (d : R) : Prop :=
  let '(x, y, z) := p in
  let '(u, v, w) := q in
  Rabs (u - x) <= d /\ Rabs (v - y) <= d /\ Rabs (w - z) <= d.

Lemma near_refl : forall p d, 0 <= d -> near p p d.
Proof. intros ((x, y), z) d H. simpl. rewrite !Rminus_eq_0, !Rabs_R0. auto. Qed.

Lemma near_sym : forall p q d, near p q d -> near q p d.
Proof. intros ((x, y), z) ((u, v), w) d. simpl. intros (A & B & C).
  rewrite Rabs_minus_sym in A. rewrite Rabs_minus_sym in B. rewrite Rabs_minus_sym in C. auto. Qed.

Lemma near_le : forall p q d d', near p q d -> d <= d' -> near p q d'.
Proof. intros ((x, y), z) ((u, v), w) d d'. simpl. intros (A & B & C) H. repeat split; lra. Qed.

Lemma near_trans : forall p q r d d', near p q d -> near q r d' -> near p r (d + d').
Proof.
  assert (T : forall a b c d d', Rabs (b - a) <= d -> Rabs (c - b) <= d' -> Rabs (c - a) <= d + d').
  { intros a b c d d' H K. replace (c - a) with ((b - a) + (c - b)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]. lra. }
  intros ((x, y), z) ((u, v), w) ((a, b), c) d d' (A & B & C) (D & E & F). simpl in *.
  repeat split; eapply T; eassumption.
Qed.

Lemma far_near : forall p q b d, far p <= b -> near p q d -> far q <= b + 2 * d.
Proof.
  intros ((x, y), z) ((u, v), w) b d Hp Hn.
  assert (0 <= b) by (pose proof (far_nonneg (x, y, z)); lra).
  destruct (component_le_far _ _ _ _ Hp) as (Ax & Ay & Az). apply le_far in Hp. simpl in *.
  destruct Hn as (Dx & Dy & Dz).
  assert (0 <= d) by (pose proof (Rabs_pos (u - x)); lra).
  apply far_le; [lra|]. simpl.
  (* |x| + |y| + |z| <= 2 b, since its square is at most 3 b^2. *)
  assert (N : Rabs x + Rabs y + Rabs z <= 2 * b).
  { pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (Rabs_pos z).
    assert (E : forall a, Rabs a * Rabs a = a * a) by (intros a; rewrite <- Rabs_mult; apply Rabs_right; nra).
    pose proof (E x). pose proof (E y). pose proof (E z).
    set (i := Rabs x) in *. set (j := Rabs y) in *. set (k := Rabs z) in *.
    assert ((i + j + k) * (i + j + k) <= 3 * (i * i + j * j + k * k)) by
      (pose proof (Rle_0_sqr (i - j)); pose proof (Rle_0_sqr (j - k)); pose proof (Rle_0_sqr (k - i)); unfold Rsqr in *; nra).
    nra. }
  assert (S : forall a c, Rabs (c - a) <= d -> c * c <= a * a + 2 * d * Rabs a + d * d).
  { intros a c Hc. set (e := c - a) in *. replace c with (a + e) by (unfold e; ring).
    assert (a * e <= Rabs a * d).
    { apply Rle_trans with (Rabs (a * e)); [apply Rle_abs|]. rewrite Rabs_mult.
      apply Rmult_le_compat_l; [apply Rabs_pos|assumption]. }
    assert (e * e <= d * d).
    { apply Rabs_le_inv in Hc. nra. }
    nra. }
  pose proof (S x u Dx). pose proof (S y v Dy). pose proof (S z w Dz). nra.
Qed.

(** Where what moves from [p] with [v], in m/s, is after [ms] milliseconds. *)
Definition moved (p v : point) (ms : R) : point :=
  let '(x, y, z) := p in
  let '(a, b, c) := v in
  (x + a * ms / 1000, y + b * ms / 1000, z + c * ms / 1000).

Lemma moved_0 : forall p v, moved p v 0 = p.
Proof. intros ((x, y), z) ((a, b), c). simpl. f_equal; [f_equal|]; lra. Qed.

Lemma moved_between : forall p v ms all, 0 < all -> moved p v ms = between p (moved p v all) (ms / all).
Proof. intros ((x, y), z) ((a, b), c) ms all H. simpl. f_equal; [f_equal|]; field; lra. Qed.

(** No component of the velocity is above [b] in magnitude. *)
Definition slow (v : point) (b : R) : Prop := near (0, 0, 0) v b.

Lemma slow_moved : forall p v b ms, slow v b -> 0 <= ms -> near p (moved p v ms) (b * ms / 1000).
Proof.
  intros ((x, y), z) ((a, c), e) b ms (A & B & C) H. rewrite !Rminus_0_r in *. simpl.
  assert (M : forall o w, Rabs w <= b -> Rabs (o + w * ms / 1000 - o) <= b * ms / 1000).
  { intros o w Hw. replace (o + w * ms / 1000 - o) with (w * (ms / 1000)) by field.
    replace (b * ms / 1000) with (b * (ms / 1000)) by field.
    rewrite Rabs_mult, (Rabs_right (ms / 1000)) by lra. apply Rmult_le_compat_r; lra. }
  repeat split; apply M; assumption.
Qed.

Lemma moved_near : forall p q v d ms, near p q d -> near (moved p v ms) (moved q v ms) d.
Proof.
  intros ((x, y), z) ((a, b), c) ((e, f), g) d ms (A & B & C). simpl.
  assert (M : forall o o' w, o' + w - (o + w) = o' - o) by (intros; ring). rewrite !M. auto.
Qed.

; latch/plant: ∀ reachable states σ × estop, events e: step(σ, e) = model.step(σ, e); active = k ⇒ k ≤ (age ⊘ dt) < k + 1 ∧ k ≤ n
; Each answer has to be unsat, 35 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(define-fun t5 () Bool (= q0 (_ bv0 64)))
(declare-const x2 Float64)
(define-fun t12 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t13 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t16 () Bool (fp.lt x1 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t17 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t18 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t19 () Bool (fp.leq x0 x2))
(define-fun t20 () Float64 (fp.sub RNE x2 x0))
(define-fun t22 () Float64 (fp.mul RNE t20 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t23 () Bool (fp.leq t22 x1))
(define-fun t24 () Bool (fp.leq t22 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(declare-const x3 Float64)
(declare-const x4 Float64)
(define-fun t48 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t49 () Bool (fp.leq x0 x4))
(define-fun t50 () Float64 (fp.sub RNE x4 x0))
(define-fun t51 () Float64 (fp.mul RNE t50 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t52 () Bool (fp.leq t51 x1))
(define-fun t53 () Bool (fp.leq t51 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t60 () Float64 (fp.div RNE t22 x3))
(define-fun t61 () Bool (fp.lt t60 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t63 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t60))
(define-fun t64 () Bool (and t61 t63))
(define-fun t66 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t67 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x3))
(define-fun t68 () Bool (and t66 t67))
(define-fun t69 () Bool (fp.lt t60 (fp #b0 #b10000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t76 () Bool (and (not t64) t68))
(define-fun t78 () Bool (fp.leq (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000) t60))
(define-fun t79 () Bool (and t69 t78))
(define-fun t81 () Bool (and t68 (not t79)))
(define-fun t83 () Bool (fp.lt t60 (fp #b0 #b10000000000 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t89 () Bool (fp.leq (fp #b0 #b10000000000 #b0000000000000000000000000000000000000000000000000000) t60))
(define-fun t90 () Bool (and t83 t89))
(define-fun t92 () Bool (and t68 (not t90)))
(define-fun t105 () Bool (bvslt q0 q0))
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert t53)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t53))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t53))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not t48))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert (not t49))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert (not t52))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert t52)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t52))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t52))(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t52)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t52)(assert (not (not t68)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t63))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t63))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t61)(assert t63)(assert t66)(assert t67)(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert (not t66))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t66)(assert (not t67))(assert (not (not t76)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not (not t81)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not (not t81)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not (not t81)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not (not t81)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not (not t92)))
(check-sat)
(pop 1)
(push 1) ; the tick is ⌊age / dt⌋
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not (not t92)))
(check-sat)
(pop 1)
(push 1) ; without a horizon it is tick 0
(assert t66)(assert t67)(assert (not t68))
(check-sat)
(pop 1)

; latch/plant: ∀ reachable states σ × estop, events e: step(σ, e) = model.step(σ, e); active = k ⇒ k ≤ (age ⊘ dt) < k + 1 ∧ k ≤ n
; Each answer has to be unsat, 400 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const q0 (_ BitVec 64))
(define-fun t5 () Bool (= q0 (_ bv0 64)))
(declare-const x2 Float64)
(define-fun t12 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t13 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x1))
(define-fun t14 () Bool (and t12 t13))
(define-fun t16 () Bool (fp.lt x1 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t17 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t18 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t19 () Bool (fp.leq x0 x2))
(define-fun t20 () Float64 (fp.sub RNE x2 x0))
(define-fun t22 () Float64 (fp.mul RNE t20 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t23 () Bool (fp.leq t22 x1))
(define-fun t24 () Bool (fp.leq t22 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(declare-const x3 Float64)
(declare-const q1 (_ BitVec 64))
(define-fun t27 () Bool (bvslt q0 q1))
(define-fun t29 () Bool (= q1 (_ bv0 64)))
(define-fun t30 () Bool (bvslt q1 q0))
(declare-const x4 Float64)
(define-fun t48 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t49 () Bool (fp.leq x0 x4))
(define-fun t50 () Float64 (fp.sub RNE x4 x0))
(define-fun t51 () Float64 (fp.mul RNE t50 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t52 () Bool (fp.leq t51 x1))
(define-fun t53 () Bool (fp.leq t51 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t54 () Bool (and t17 t18))
(define-fun t55 () Bool (and t19 t54))
(define-fun t56 () Bool (and t14 t55))
(define-fun t57 () Bool (and t23 t56))
(define-fun t58 () Bool (and t24 t57))
(define-fun t60 () Float64 (fp.div RNE t22 x3))
(define-fun t61 () Bool (fp.lt t60 (fp #b0 #b01111111111 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t63 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t60))
(define-fun t66 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t67 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x3))
(define-fun t68 () Bool (and t66 t67))
(define-fun t69 () Bool (fp.lt t60 (fp #b0 #b10000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t71 () Bool (and t68 (not t69)))
(define-fun t73 () Bool (and t58 (not t71)))
(define-fun t83 () Bool (fp.lt t60 (fp #b0 #b10000000000 #b1000000000000000000000000000000000000000000000000000)))
(define-fun t85 () Bool (and t68 (not t83)))
(define-fun t87 () Bool (and t58 (not t85)))
(define-fun t100 () Bool (fp.leq x0 x3))
(define-fun t101 () Float64 (fp.sub RNE x3 x0))
(define-fun t102 () Float64 (fp.mul RNE t101 (fp #b0 #b10000001000 #b1111010000000000000000000000000000000000000000000000)))
(define-fun t103 () Bool (fp.leq t102 x1))
(define-fun t104 () Bool (fp.leq t102 (fp #b0 #b10000001110 #b1101010011000000000000000000000000000000000000000000)))
(define-fun t105 () Bool (bvslt q0 q0))
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t52))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t52))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert (not t52))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert (not t52))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert (not t103))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert (not t103))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert (not t103))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert t103)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert t103)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert t103)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t12))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert (not t13))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t17))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert (not t18))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert (not t19))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert (not t23))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not t58)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t66))(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t67))(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t63))(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t73))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t12))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert (not t13))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t17))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert (not t18))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert (not t19))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert (not t23))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t69))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t69))(assert (not (not t73)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t66))(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t67))(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t63))(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t87))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert (not t12))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert (not t13))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert (not t17))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert (not t18))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert (not t19))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert (not t23))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t83))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; moves exactly while alive, free and before the end
(assert t12)(assert t13)(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t83))(assert (not (not t87)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t66))(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert (not t66))(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert t103)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert t103)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert t18)(assert t19)(assert t23)(assert t66)(assert t100)(assert t103)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert (not t27))(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert (not t27))(assert t12)(assert t13)(assert t16)(assert t48)(assert t18)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert (not t29))(assert t30)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert (not t29))(assert t30)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert (not t29))(assert t30)(assert t12)(assert t13)(assert t16)(assert t48)(assert t18)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; nothing moves while stopped or held
(assert (not t5))(assert t105)(assert (not t29))(assert t30)(assert t12)(assert t13)(assert t16)(assert t48)(assert t18)(assert t49)(assert t52)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; only what advances counts
(assert t27)(assert (not t27))
(check-sat)
(pop 1)
(push 1) ; only what advances counts
(assert (not t27))(assert (not (not t27)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert (not t12))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert (not t13))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert (not t19))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert (not t24))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert (not t66))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t67))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert (not t63))(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert (not t83))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert (not t69))(assert t83)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert (not t61))(assert t69)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t67)(assert t63)(assert t61)(assert t48)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert (not t100))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert (not t104))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t17)(assert t18)(assert t19)(assert t24)(assert t66)(assert t100)(assert t104)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert (not t48))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert (not t49))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert (not t53))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert (not t16))(assert t48)(assert t18)(assert t49)(assert t53)(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert (not t17))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)
(push 1) ; the state is the model's
(assert (not t5))(assert t105)(assert t12)(assert t13)(assert t16)(assert t17)(assert (not t18))(assert (not (not true)))
(check-sat)
(pop 1)

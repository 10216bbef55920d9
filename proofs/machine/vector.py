def case(defect, wanted, found, right):
    return None

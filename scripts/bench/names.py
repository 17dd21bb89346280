"""A demangled C++ name, as short as a reader needs it."""
import re

_OPERATOR_WITH_BRACKETS = re.compile(r"operator(\(\)|<=>|<<=?|>>=?|<=|>=|->\*?|<|>)")
_BESIDE_THE_NAME = re.compile(r" \[clone [^]]*\]|\[abi:[^]]*\]|\(anonymous namespace\)::|shade16::|detail::")


def _without(text, opening, closing):
    """The text without what stands between brackets, at any depth."""
    depth, kept = 0, []
    for letter in text:
        depth += letter == opening
        if depth == 0:
            kept.append(letter)
        depth -= letter == closing
    return "".join(kept)


def short_name(demangled):
    """'void shade16::walk<false>(shade16::Box const&)' is 'walk'; a lambda keeps the name of the function around it."""
    operators = _OPERATOR_WITH_BRACKETS.findall(demangled)
    text = _OPERATOR_WITH_BRACKETS.sub("operator@", _BESIDE_THE_NAME.sub("", demangled))
    text = _without(_without(text, "<", ">"), "(", ")")
    text = re.sub(r" const(?=::|$)", "", re.sub(r"\{lambda[^}]*\}", "{lambda}", text))
    name = text.strip().rsplit(" ", 1)[-1]  # what stands before it is the type of the result
    for operator in operators:
        name = name.replace("operator@", "operator" + operator, 1)
    return name

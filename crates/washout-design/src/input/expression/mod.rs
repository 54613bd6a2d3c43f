//! Formulas that a user writes: `k * q * chord^2 * sin(2 * alpha)`, read once, computed with numbers or dual numbers.
//!
//! Numbers, names, `+ - * / ^` (power binds tighter than a sign, and to the right), brackets, and the functions of
//! [`FUNCTIONS`]. Nothing else can be written, so that a formula can neither hang nor reach outside.

mod functions;

pub use functions::FUNCTIONS;

use num_dual::DualNum;
use thiserror::Error;

use super::nearest;
use functions::{call, divide, power, power_of};

/// Brackets and powers within each other at most.
const DEEPEST: usize = 64;
/// Characters at most.
const LONGEST: usize = 4000;

/// A formula over named variables.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    /// As written.
    pub text: String,
    steps: Vec<Step>,
    variables: usize,
}

/// A step of the stack machine.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    Number(f64),
    Variable(usize),
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    PowerOf(f64),
    Call(usize),
}

/// What is wrong with a formula.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("'{text}', column {column}: {problem}; {cure}")]
pub struct ExpressionError {
    /// The formula.
    pub text: String,
    /// Where, counted from 1 in characters.
    pub column: usize,
    /// What.
    pub problem: String,
    /// What to do.
    pub cure: String,
}

impl Expression {
    /// Reads a formula over these names; `pi` is known besides.
    ///
    /// # Errors
    /// Where and why it cannot be read.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// use washout::input::Expression;
    ///
    /// let formula = Expression::parse("2*x^2 + sin(pi*y)", &["x", "y"])?;
    /// assert!((formula.value(&[3.0_f64, 0.5]) - 19.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn parse(text: &str, names: &[&str]) -> Result<Expression, ExpressionError> {
        let mut reader = Reader {
            text,
            letters: text.chars().collect(),
            at: 0,
            depth: 0,
            names,
            steps: Vec::new(),
        };
        if reader.letters.len() > LONGEST {
            return Err(reader.fault(
                LONGEST,
                "the formula is too long",
                "split it into several effects",
            ));
        }
        reader.sum()?;
        reader.skip_space();
        if let Some(&letter) = reader.letters.get(reader.at) {
            let cure = match letter {
                ')' => "delete it, or open a bracket before".to_string(),
                _ => format!("put an operator (+ - * / ^) before '{letter}', or delete it"),
            };
            return Err(reader.fault(
                reader.at,
                &format!("'{letter}' stands where the formula should end"),
                &cure,
            ));
        }
        Ok(Expression {
            text: text.to_string(),
            steps: reader.steps,
            variables: names.len(),
        })
    }

    /// Whether the formula names the variable at this place of the names.
    pub fn uses(&self, variable: usize) -> bool {
        self.steps.contains(&Step::Variable(variable))
    }

    /// The value, for the variables in the order of the names, of numbers or dual numbers of first order; not finite where the
    /// formula is not (1/0, ln 0), and its derivative only where that is not (√0).
    pub fn value<D: DualNum<Primitive = f64> + Copy>(&self, variables: &[D]) -> D {
        let nothing = D::from(f64::NAN);
        if variables.len() < self.variables {
            return nothing;
        }
        let mut stack: Vec<D> = Vec::with_capacity(16);
        for step in &self.steps {
            let last = match step {
                Step::Number(number) => D::from(*number),
                Step::Variable(place) => variables[*place],
                Step::Negate => -stack.pop().unwrap_or(nothing),
                Step::PowerOf(exponent) => power(stack.pop().unwrap_or(nothing), *exponent),
                Step::Call(function) => {
                    let last = stack.pop().unwrap_or(nothing);
                    let (name, count) = FUNCTIONS[*function];
                    let first = if count == 2 {
                        stack.pop().unwrap_or(nothing)
                    } else {
                        last
                    };
                    call(name, first, last)
                }
                binary => {
                    let last = stack.pop().unwrap_or(nothing);
                    let first = stack.pop().unwrap_or(nothing);
                    match binary {
                        Step::Add => first + last,
                        Step::Subtract => first - last,
                        Step::Multiply => first * last,
                        Step::Divide => divide(first, last),
                        _ => power_of(first, last),
                    }
                }
            };
            stack.push(last);
        }
        stack.pop().unwrap_or(nothing)
    }
}

struct Reader<'a> {
    text: &'a str,
    letters: Vec<char>,
    at: usize,
    depth: usize,
    names: &'a [&'a str],
    steps: Vec<Step>,
}

impl Reader<'_> {
    fn fault(&self, at: usize, problem: &str, cure: &str) -> ExpressionError {
        ExpressionError {
            text: self.text.to_string(),
            column: at + 1,
            problem: problem.to_string(),
            cure: cure.to_string(),
        }
    }

    fn skip_space(&mut self) {
        while self
            .letters
            .get(self.at)
            .is_some_and(|letter| letter.is_whitespace())
        {
            self.at += 1;
        }
    }

    /// Takes the next letter if it is one of these.
    fn take(&mut self, wanted: &[char]) -> Option<char> {
        self.skip_space();
        let letter = *self.letters.get(self.at)?;
        wanted.contains(&letter).then(|| {
            self.at += 1;
            letter
        })
    }

    fn sum(&mut self) -> Result<(), ExpressionError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            let cure = format!("write it with at most {DEEPEST} brackets and powers within each other");
            return Err(self.fault(self.at, "the formula is nested too deeply", &cure));
        }
        self.product()?;
        while let Some(sign) = self.take(&['+', '-']) {
            self.product()?;
            self.steps
                .push(if sign == '+' { Step::Add } else { Step::Subtract });
        }
        self.depth -= 1;
        Ok(())
    }

    fn product(&mut self) -> Result<(), ExpressionError> {
        self.signed()?;
        while let Some(sign) = self.take(&['*', '/']) {
            if self.letters.get(self.at) == Some(&'*') {
                return Err(self.fault(self.at - 1, "'**' is no operator", "write a power as a^b"));
            }
            self.signed()?;
            self.steps
                .push(if sign == '*' { Step::Multiply } else { Step::Divide });
        }
        Ok(())
    }

    fn signed(&mut self) -> Result<(), ExpressionError> {
        let mut negative = false;
        while let Some(sign) = self.take(&['-', '+']) {
            negative ^= sign == '-';
        }
        self.factor()?;
        if negative {
            self.steps.push(Step::Negate);
        }
        Ok(())
    }

    fn factor(&mut self) -> Result<(), ExpressionError> {
        self.primary()?;
        if self.take(&['^']).is_some() {
            self.depth += 1;
            if self.depth > DEEPEST {
                return Err(self.fault(
                    self.at,
                    "the formula is nested too deeply",
                    "use fewer powers of powers",
                ));
            }
            let before = self.steps.len();
            self.signed()?;
            self.depth -= 1;
            let exponent = Expression {
                text: String::new(),
                steps: self.steps.split_off(before),
                variables: 0,
            };
            if exponent
                .steps
                .iter()
                .any(|step| matches!(step, Step::Variable(_)))
            {
                self.steps.extend(exponent.steps);
                self.steps.push(Step::Power);
            } else {
                self.steps.push(Step::PowerOf(exponent.value(&[])));
            }
        }
        Ok(())
    }

    fn primary(&mut self) -> Result<(), ExpressionError> {
        self.skip_space();
        let start = self.at;
        match self.letters.get(start).copied() {
            Some('(') => {
                self.at += 1;
                self.sum()?;
                self.close(start)
            }
            Some(letter) if letter.is_ascii_digit() || letter == '.' => self.number(),
            Some(letter) if letter.is_alphabetic() || letter == '_' => self.name(),
            Some(letter) => {
                let cure = "write a number, a name or a bracket here";
                Err(self.fault(start, &format!("'{letter}' cannot stand here"), cure))
            }
            None => {
                let cure = "write a number, a name or a bracket at the end";
                Err(self.fault(start, "the formula ends too early", cure))
            }
        }
    }

    fn close(&mut self, opened: usize) -> Result<(), ExpressionError> {
        match self.take(&[')']) {
            Some(_) => Ok(()),
            None => Err(self.fault(opened, "this bracket is not closed", "put ) where it ends")),
        }
    }

    fn number(&mut self) -> Result<(), ExpressionError> {
        let start = self.at;
        let mut end = start;
        while let Some(&letter) = self.letters.get(end) {
            let after_e = end > start && matches!(self.letters[end - 1], 'e' | 'E');
            let is_exponent = matches!(letter, 'e' | 'E')
                && self
                    .letters
                    .get(end + 1)
                    .is_some_and(|next| next.is_ascii_digit() || "+-".contains(*next));
            if letter.is_ascii_digit() || letter == '.' || is_exponent || (after_e && "+-".contains(letter)) {
                end += 1;
            } else {
                break;
            }
        }
        let word: String = self.letters[start..end].iter().collect();
        let Some(number) = word.parse::<f64>().ok().filter(|number| number.is_finite()) else {
            return Err(self.fault(start, &format!("'{word}' is no number"), "write e.g. 0.5 or 2e-3"));
        };
        self.at = end;
        self.skip_space();
        match self.letters.get(self.at) {
            Some(letter) if letter.is_alphabetic() || *letter == '(' || *letter == '_' => {
                let cure = format!("write {word} * {letter}…; numbers carry no unit");
                Err(self.fault(self.at, "an operator is missing behind a number", &cure))
            }
            _ => {
                self.steps.push(Step::Number(number));
                Ok(())
            }
        }
    }

    fn name(&mut self) -> Result<(), ExpressionError> {
        let start = self.at;
        while (self.letters.get(self.at)).is_some_and(|letter| letter.is_alphanumeric() || *letter == '_') {
            self.at += 1;
        }
        let word: String = self.letters[start..self.at].iter().collect();
        if let Some(place) = self.names.iter().position(|name| *name == word) {
            self.steps.push(Step::Variable(place));
            return Ok(());
        }
        if word == "pi" {
            self.steps.push(Step::Number(std::f64::consts::PI));
            return Ok(());
        }
        let Some(function) = FUNCTIONS.iter().position(|(name, _)| *name == word) else {
            let known: Vec<&str> = self
                .names
                .iter()
                .copied()
                .chain(FUNCTIONS.iter().map(|(name, _)| *name))
                .collect();
            let cure = match nearest(&word, known.iter().copied()) {
                Some(near) => format!("did you mean {near}? There are {}", known.join(", ")),
                None => format!("there are {}", known.join(", ")),
            };
            return Err(self.fault(start, &format!("there is no {word}"), &cure));
        };
        self.arguments(function, &word)
    }

    fn arguments(&mut self, function: usize, word: &str) -> Result<(), ExpressionError> {
        let count = FUNCTIONS[function].1;
        let example = if count == 1 {
            format!("{word}(a)")
        } else {
            format!("{word}(a, b)")
        };
        let opened = self.at;
        if self.take(&['(']).is_none() {
            return Err(self.fault(
                opened,
                &format!("{word} is a function"),
                &format!("write {example}"),
            ));
        }
        for argument in 0..count {
            if argument > 0 && self.take(&[',']).is_none() {
                let problem = format!("{word} takes {count} values");
                return Err(self.fault(self.at, &problem, &format!("write {example}")));
            }
            self.sum()?;
        }
        if self.take(&[',']).is_some() {
            let problem = format!("{word} takes {count} value{}", if count == 1 { "" } else { "s" });
            return Err(self.fault(self.at - 1, &problem, &format!("write {example}")));
        }
        self.close(opened)?;
        self.steps.push(Step::Call(function));
        Ok(())
    }
}

#[cfg(test)]
mod tests;

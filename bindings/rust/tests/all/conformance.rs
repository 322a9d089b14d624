//! The scenes of bindings/conformance: the same hashes as in every other language.
use crate::scene_calls::*;
use contdyn::*;

struct Statement {
    line: usize,
    words: Vec<String>,
}

/// Lines that begin with a space go on with the statement before.
fn statements() -> Vec<Statement> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../conformance/scenes.txt");
    let text = std::fs::read_to_string(path).unwrap();
    let mut found: Vec<Statement> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        if !line.starts_with(' ') {
            found.push(Statement { line: number + 1, words: Vec::new() });
        }
        found.last_mut().unwrap().words.extend(line.split_whitespace().map(str::to_string));
    }
    found
}

/// The arguments of a call; an array is one of them.
pub struct Words<'a> {
    arguments: Vec<&'a [String]>,
    precision: Precision,
}

impl<'a> Words<'a> {
    fn new(words: &'a [String], precision: Precision) -> Words<'a> {
        let mut arguments = Vec::new();
        let mut rest = words;
        while !rest.is_empty() {
            let is_array = rest[0] == "[";
            let length = if is_array { rest.iter().position(|word| word == "]").unwrap() + 1 } else { 1 };
            arguments.push(if is_array { &rest[1..length - 1] } else { &rest[..1] });
            rest = &rest[length..];
        }
        Words { arguments, precision }
    }

    fn word(&self, k: usize) -> &str {
        &self.arguments[k][0]
    }

    pub fn number(&self, k: usize) -> f64 {
        number_of(self.word(k))
    }

    pub fn size(&self, k: usize) -> usize {
        self.word(k).parse().unwrap()
    }

    pub fn flag(&self, k: usize) -> bool {
        self.number(k) != 0.0
    }

    /// The type refuses what the library would: a number that is none of the enumerators.
    pub fn enumerator<T>(&self, k: usize, from_raw: fn(i32) -> Option<T>) -> std::result::Result<T, i32> {
        let word = self.word(k);
        let value = if word == "precision" { self.precision as i32 } else { number_of(word) as i32 };
        from_raw(value).ok_or(Status::ErrorEnum as i32)
    }

    pub fn doubles(&self, k: usize) -> Option<Vec<f64>> {
        let words = self.arguments[k];
        let null = words.len() == 1 && words[0] == "null";
        (!null).then(|| words.iter().map(|word| number_of(word)).collect())
    }

    #[allow(dead_code)] // for calls with arrays of whole numbers
    pub fn integers<T: TryFrom<i64>>(&self, k: usize) -> Option<Vec<T>> {
        Some(self.doubles(k)?.into_iter().map(|number| T::try_from(number as i64).ok().unwrap()).collect())
    }

    pub fn floats(&self, k: usize) -> Option<Vec<f32>> {
        Some(self.doubles(k)?.into_iter().map(|number| number as f32).collect())
    }
}

fn enumerator_of(word: &str) -> Option<i32> {
    ENUMERATORS.iter().find(|(name, _)| *name == word).map(|(_, value)| *value)
}

fn number_of(word: &str) -> f64 {
    match word {
        "INFINITY" => f64::INFINITY,
        _ => word.parse().unwrap_or_else(|_| f64::from(enumerator_of(word).expect(word))),
    }
}

enum Object {
    None,
    Chain(Chain),
    Membrane(Membrane),
    Water(Water),
}

/// Calls the same method of whatever the object is.
macro_rules! each {
    ($object:expr, $o:ident => $call:expr) => {
        match $object {
            Object::Chain($o) => $call,
            Object::Membrane($o) => $call,
            Object::Water($o) => $call,
            Object::None => panic!("no object"),
        }
    };
}

impl Object {
    fn make(kind: &str, words: &Words, kernels: Kernels) -> Object {
        let mut made = match kind {
            "chain" => Object::Chain(make_chain(words).unwrap()),
            "membrane" => Object::Membrane(make_membrane(words).unwrap()),
            "water" => Object::Water(make_water(words).unwrap()),
            _ => panic!("no object {kind}"),
        };
        each!(&mut made, o => o.set_kernels(kernels)).unwrap();
        made
    }

    /// Fails with the status.
    fn call(&mut self, name: &str, words: &Words) -> std::result::Result<(), i32> {
        match self {
            Object::Chain(o) => call_chain(o, name, words),
            Object::Membrane(o) => call_membrane(o, name, words),
            Object::Water(o) => call_water(o, name, words),
            Object::None => panic!("no object"),
        }
    }

    fn copy_state(&mut self, from: &Object) -> Result<()> {
        match (self, from) {
            (Object::Chain(o), Object::Chain(from)) => o.copy_state(from),
            (Object::Membrane(o), Object::Membrane(from)) => o.copy_state(from),
            (Object::Water(o), Object::Water(from)) => o.copy_state(from),
            _ => panic!("other kinds"),
        }
    }
}

/// How many hashes were compared.
fn play(all: &[Statement], precision: Precision, kernels: Kernels) -> usize {
    let mut object = Object::None;
    let mut made_by: &[String] = &[];
    let mut compared = 0;
    for Statement { line, words } in all {
        let make = |by: &[String]| Object::make(&by[1], &Words::new(&by[2..], precision), kernels);
        match words[0].as_str() {
            "scene" => object = Object::None,
            "create" => {
                made_by = words;
                object = make(made_by);
            }
            "copy" => {
                let mut other = make(made_by);
                other.copy_state(&object).unwrap();
                object = other;
            }
            "save_and_load" => {
                let saved = each!(&object, o => o.save()).unwrap();
                object = make(made_by);
                each!(&mut object, o => o.load(&saved)).unwrap();
            }
            "hash" => {
                let wanted = &words[1 + precision as usize];
                let found = each!(&object, o => o.hash()).unwrap();
                assert_eq!(format!("{found:#018x}"), *wanted, "line {line}, {precision:?}, {kernels:?}");
                compared += 1;
            }
            "refused" => {
                let status = object.call(&words[2], &Words::new(&words[3..], precision)).expect_err(&words[2]);
                assert_eq!(Some(status), enumerator_of(&words[1]), "line {line}: {}", error_message());
            }
            name => object
                .call(name, &Words::new(&words[1..], precision))
                .unwrap_or_else(|status| panic!("line {line}: {status}, {}", error_message())),
        }
    }
    compared
}

#[test]
fn scenes_give_the_same_hashes() {
    let all = statements();
    let mut compared = 0;
    for kernels in Kernels::ALL {
        if runnable_kernels() & 1 << kernels as u32 != 0 {
            for precision in Precision::ALL {
                compared += play(&all, precision, kernels);
            }
        }
    }
    assert!(compared > 10);
    println!("{compared} hashes compared");
}

#[test]
fn another_step_is_another_hash() {
    let mut rope = Chain::new(1, 12, 2, Precision::Float64).unwrap();
    let before = rope.hash().unwrap();
    rope.step(0.01, 1).unwrap();
    assert_ne!(rope.hash().unwrap(), before);
}

//! Objects release what they hold, once; they go to other threads; callbacks.
use crate::refused;
use contdyn::*;
use std::alloc::{alloc, dealloc, Layout};
use std::os::raw::c_void;
use std::sync::atomic::{AtomicUsize, Ordering};

unsafe extern "C" fn allocate(user: *mut c_void, size: usize, alignment: usize) -> *mut c_void {
    (*user.cast::<AtomicUsize>()).fetch_add(1, Ordering::Relaxed);
    alloc(Layout::from_size_align(size.max(1), alignment).unwrap()).cast()
}

unsafe extern "C" fn release(user: *mut c_void, pointer: *mut c_void, size: usize, alignment: usize) {
    (*user.cast::<AtomicUsize>()).fetch_sub(1, Ordering::Relaxed);
    dealloc(pointer.cast(), Layout::from_size_align(size.max(1), alignment).unwrap());
}

unsafe extern "C" fn nothing(_: *mut c_void, _: usize, _: usize) -> *mut c_void {
    std::ptr::null_mut()
}

#[test]
fn owned_once() {
    let live = AtomicUsize::new(0);
    let user = std::ptr::addr_of!(live) as *mut c_void;
    let allocator = sys::cd_allocator { user, allocate: Some(allocate), release: Some(release) };
    {
        let rope = unsafe { Chain::create(1, 10, 3, Precision::Float32, Some(&allocator)) }.unwrap();
        assert!(live.load(Ordering::Relaxed) > 0);
        let moved = rope;
        let raw = moved.into_raw();
        let back = unsafe { Chain::from_raw(raw) };
        assert_eq!(back.as_ptr(), raw);
        assert!(format!("{back:?}").contains("springs: 10"));
    }
    assert_eq!(live.load(Ordering::Relaxed), 0);
    let empty = sys::cd_allocator { allocate: Some(nothing), ..allocator };
    let none = unsafe { Water::create(4, 4, 1.0, 1.0, Precision::Float64, Some(&empty)) };
    refused(none, Status::ErrorMemory, "cd_water_create");
}

#[test]
fn failed_calls_change_nothing() {
    refused(Chain::new(1, 10, 5, Precision::Float64), Status::ErrorValue, "cd_chain_create: components is 5");
    let mut rope = Chain::new(1, 4, 1, Precision::Float64).unwrap();
    let before = rope.hash().unwrap();
    refused(rope.set_mass(-1.0), Status::ErrorValue, "mass is -1");
    refused(rope.view(Field::Force).map(|_| ()), Status::ErrorDisabled, "cd_chain_view");
    assert_eq!(rope.hash().unwrap(), before);
    rope.set_method(Method::ForwardEuler).unwrap();
    rope.set_stiffness(1e50).unwrap();
    rope.write_f64(Field::Position, 0, 1, 2, 1, &[1e300]).unwrap();
    refused(rope.step(1.0, 1000), Status::ErrorDiverged, "cd_chain_step");
    rope.reset().unwrap();
    let other = Chain::new(1, 5, 1, Precision::Float64).unwrap();
    refused(rope.copy_state(&other), Status::ErrorMismatch, "cd_chain_copy_state");
    refused(rope.load(&[1, 2, 3]), Status::ErrorFormat, "cd_chain_load");
}

fn large() -> Chain {
    let mut made = Chain::new(100, 20, 3, Precision::Float64).unwrap();
    made.set_gravity(&[0.0, -1.0, 0.0]).unwrap();
    made.set_end(End::First, Node::Pinned).unwrap();
    made
}

#[test]
fn objects_go_to_other_threads() {
    let mut here = large();
    here.step(0.01, 10).unwrap();
    let ropes: Vec<_> = (0..4).map(|_| large()).collect();
    let threads: Vec<_> = ropes
        .into_iter()
        .map(|mut rope| {
            std::thread::spawn(move || {
                rope.step(0.01, 10).unwrap();
                rope
            })
        })
        .collect();
    for thread in threads {
        assert_eq!(thread.join().unwrap().hash(), here.hash());
    }
}

type Task = Option<unsafe extern "C" fn(*mut c_void, usize)>;

struct Context(*mut c_void);
unsafe impl Sync for Context {}

/// Deals the work out to two threads.
unsafe extern "C" fn run(user: *mut c_void, count: usize, task: Task, context: *mut c_void) {
    (*user.cast::<AtomicUsize>()).fetch_add(count, Ordering::Relaxed);
    let (task, context) = (task.unwrap(), &Context(context));
    std::thread::scope(|scope| {
        for first in 0..2 {
            scope.spawn(move || {
                let context = context;
                for index in (first..count).step_by(2) {
                    task(context.0, index);
                }
            });
        }
    });
}

#[test]
fn work_is_spread_and_the_bits_are_the_same() {
    let pieces = AtomicUsize::new(0);
    let user = std::ptr::addr_of!(pieces) as *mut c_void;
    let (mut alone, mut spread) = (large(), large());
    unsafe { spread.set_parallel(Some(&sys::cd_parallel { user, run: Some(run) })) }.unwrap();
    alone.step(0.01, 20).unwrap();
    spread.step(0.01, 20).unwrap();
    let counted = pieces.load(Ordering::Relaxed);
    assert!(counted > 1);
    assert_eq!(alone.hash(), spread.hash());
    unsafe { spread.set_parallel(None) }.unwrap();
    spread.step(0.01, 1).unwrap();
    assert_eq!(pieces.load(Ordering::Relaxed), counted);
}

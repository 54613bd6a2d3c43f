//! Connections: a bounded number at a time, one thread each; whoever sends slowly makes room for who comes next.

use std::io;
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use crate::progress::Progress;

use super::answer::{Answer, Status};
use super::guard::Guard;
use super::request;
use super::service::{self, Service};

/// Connections at a time.
const MOST: usize = 64;
/// Memory of a thread's stack, bytes: answers may mesh a wing.
const STACK: usize = 4 * 1024 * 1024;
/// Time in which an answer must be taken.
const SEND_TIME: Duration = Duration::from_secs(20);
/// How often the door looks whether it is to be closed.
const LOOK: Duration = Duration::from_millis(20);

/// A connection that is served.
struct Guest {
    number: u64,
    /// Whether all of its request has come.
    is_heard: bool,
    stream: TcpStream,
}

/// The door.
pub struct Door {
    listener: TcpListener,
    guard: Arc<Guard>,
    guests: Arc<Mutex<Vec<Guest>>>,
}

impl Door {
    /// The door of a listener, with who stands at it.
    ///
    /// # Errors
    /// If the listener cannot be asked without waiting.
    pub fn new(listener: TcpListener, guard: Guard) -> io::Result<Door> {
        listener.set_nonblocking(true)?;
        Ok(Door {
            listener,
            guard: Arc::new(guard),
            guests: Arc::default(),
        })
    }

    /// Serves whoever comes, until `stop` is cancelled.
    ///
    /// # Errors
    /// If the listener fails.
    pub fn serve(&self, behind: Arc<dyn Service>, stop: &Progress) -> io::Result<()> {
        let mut number = 0;
        while !stop.is_cancelled() {
            match self.listener.accept() {
                Ok((stream, _)) => {
                    number += 1;
                    // one that is gone already, or for which there is no thread, is let go
                    let _ = self.admit(number, stream, Arc::clone(&behind));
                }
                // none has come, or one is gone again; too many files open: wait for some to be closed
                Err(_) => std::thread::sleep(LOOK),
            }
        }
        Ok(())
    }

    fn admit(&self, number: u64, mut stream: TcpStream, behind: Arc<dyn Service>) -> io::Result<()> {
        stream.set_nonblocking(false)?;
        stream.set_write_timeout(Some(SEND_TIME))?;
        stream.set_nodelay(true)?;
        let guest = Guest {
            number,
            is_heard: false,
            stream: stream.try_clone()?,
        };
        if !self.makes_room(guest) {
            stream.set_write_timeout(Some(LOOK))?;
            return Answer::empty(Status::Busy).send(&mut stream);
        }
        let guests = Arc::clone(&self.guests);
        let guard = Arc::clone(&self.guard);
        let thread = std::thread::Builder::new().stack_size(STACK);
        let started = thread.spawn(move || {
            let _leaves = Leaves {
                number,
                guests: Arc::clone(&guests),
            };
            serve(&mut stream, &guard, &*behind, || is_heard(&guests, number));
        });
        if started.is_err() {
            drop(Leaves {
                number,
                guests: Arc::clone(&self.guests),
            });
        }
        started.map(drop)
    }

    /// Adds a guest; where there are too many, the one that has been sending its request for longest goes. `false` if none can.
    fn makes_room(&self, guest: Guest) -> bool {
        let mut guests = self.guests.lock().unwrap_or_else(PoisonError::into_inner);
        if guests.len() >= MOST {
            let Some(slowest) = guests.iter().position(|guest| !guest.is_heard) else {
                return false;
            };
            let slow = guests.remove(slowest);
            // it may be gone already
            let _ = slow.stream.shutdown(Shutdown::Both);
        }
        guests.push(guest);
        true
    }
}

fn is_heard(guests: &Mutex<Vec<Guest>>, number: u64) {
    let mut guests = guests.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(guest) = guests.iter_mut().find(|guest| guest.number == number) {
        guest.is_heard = true;
    }
}

/// Takes a guest off the list, however its thread ends.
struct Leaves {
    number: u64,
    guests: Arc<Mutex<Vec<Guest>>>,
}

impl Drop for Leaves {
    fn drop(&mut self) {
        let mut guests = self.guests.lock().unwrap_or_else(PoisonError::into_inner);
        guests.retain(|guest| guest.number != self.number);
    }
}

/// Hears one request and answers it.
fn serve(stream: &mut TcpStream, guard: &Guard, behind: &dyn Service, is_heard: impl FnOnce()) {
    let answer = match hear(stream, guard) {
        Ok((passed, body)) => {
            is_heard();
            service::answer(behind, &passed, &body)
        }
        Err(Some(status)) => Answer::empty(status),
        Err(None) => return,
    };
    // nobody may be left to take it
    if answer.send(stream).is_ok() {
        let _ = stream.shutdown(Shutdown::Write);
        drain(stream);
    }
}

/// Takes a little of what still comes: where a connection is closed on unread bytes, the answer is lost on its way.
fn drain(stream: &mut TcpStream) {
    let _ = stream.set_read_timeout(Some(LOOK));
    let mut rest = [0u8; 8192];
    for _ in 0..128 {
        match io::Read::read(stream, &mut rest) {
            Ok(0) | Err(_) => return,
            Ok(_) => {}
        }
    }
}

fn hear(stream: &mut TcpStream, guard: &Guard) -> Result<(super::guard::Passed, Vec<u8>), Option<Status>> {
    let (head, came) = request::head(stream)?;
    let passed = guard.pass(&head).map_err(Some)?;
    let body = request::body(stream, came, passed.length)?;
    Ok((passed, body))
}

//! Connections, by hyper: bounded in number, and each in the size and the time of what it sends and takes.

use std::convert::Infallible;
use std::io;
use std::net::TcpListener;
use std::sync::Arc;
use std::time::Duration;

use http_body_util::{BodyExt, Limited};
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Request, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpStream;
use tokio::runtime::Builder;
use tokio::sync::{Notify, Semaphore};
use tokio::task::spawn_blocking;
use tokio::time::{sleep, timeout};

use crate::progress::Progress;

use super::answer::{self, Answer};
use super::guard::Guard;
use super::service::{self, Service};

/// Connections at a time; those beyond wait.
const MOST: usize = 512;
/// Requests that are answered at a time; those beyond are told to come again.
const MOST_ANSWERED: usize = 64;
/// Memory of the stack of a thread, bytes: answers may mesh a wing.
const STACK: usize = 4 * 1024 * 1024;
/// Bytes that the head of a request may have.
const HEAD: usize = 16 * 1024;
/// Time in which the head must have come.
const HEAD_TIME: Duration = Duration::from_secs(5);
/// Time in which the body must have come.
const BODY_TIME: Duration = Duration::from_secs(15);
/// Time in which an answer must be taken.
const SEND_TIME: Duration = Duration::from_secs(20);
/// How often the door looks whether it is to be closed.
const LOOK: Duration = Duration::from_millis(20);

/// The door.
pub struct Door {
    guard: Guard,
    service: Arc<dyn Service>,
    answered: Semaphore,
}

impl Door {
    /// A door with who stands at it, and what stands behind.
    pub fn new(guard: Guard, service: Arc<dyn Service>) -> Door {
        Door {
            guard,
            service,
            answered: Semaphore::new(MOST_ANSWERED),
        }
    }

    /// Serves whoever comes, until `stop` is cancelled.
    ///
    /// # Errors
    /// If the system gives no thread to wait in, or the listener cannot be waited for.
    pub fn serve(self, listener: TcpListener, stop: &Progress) -> io::Result<()> {
        listener.set_nonblocking(true)?;
        let mut builder = Builder::new_current_thread();
        builder
            .max_blocking_threads(MOST_ANSWERED)
            .thread_stack_size(STACK);
        let runtime = builder.enable_io().enable_time().build()?;
        let served = runtime.block_on(Arc::new(self).wait(listener, stop));
        // a question for news may be held for half a minute more, and nobody is left to hear its answer
        runtime.shutdown_background();
        served
    }

    async fn wait(self: Arc<Door>, listener: TcpListener, stop: &Progress) -> io::Result<()> {
        let listener = tokio::net::TcpListener::from_std(listener)?;
        let places = Arc::new(Semaphore::new(MOST));
        while !stop.is_cancelled() {
            let Ok(place) = timeout(LOOK, Arc::clone(&places).acquire_owned()).await else {
                continue;
            };
            match timeout(LOOK, listener.accept()).await {
                Ok(Ok((stream, _))) => {
                    let door = Arc::clone(&self);
                    tokio::spawn(async move {
                        door.admit(stream).await;
                        drop(place);
                    });
                }
                // one is gone again, or too many files are open: wait for some to be closed
                Ok(Err(_)) => sleep(LOOK).await,
                // none has come
                Err(_) => {}
            }
        }
        Ok(())
    }

    /// One request of one connection.
    async fn admit(self: Arc<Door>, stream: TcpStream) {
        let is_answered = Arc::new(Notify::new());
        let service = service_fn(|request| {
            let (door, is_answered) = (Arc::clone(&self), Arc::clone(&is_answered));
            async move {
                let answer = door.answer(request).await;
                is_answered.notify_one();
                Ok::<Answer, Infallible>(answer)
            }
        });
        let mut connection = http1::Builder::new();
        connection
            .timer(TokioTimer::new())
            .header_read_timeout(HEAD_TIME)
            .max_buf_size(HEAD)
            .keep_alive(false);
        let served = connection.serve_connection(TokioIo::new(stream), service);
        let is_late = async {
            is_answered.notified().await;
            sleep(SEND_TIME).await;
        };
        tokio::select! {
            // whoever is gone, or too slow, is let go
            _ = served => {}
            () = is_late => {}
        }
    }

    async fn answer(self: Arc<Door>, request: Request<Incoming>) -> Answer {
        let (head, body) = request.into_parts();
        let passed = match self.guard.pass(&head) {
            Ok(passed) => passed,
            Err(status) => {
                drain(body).await;
                return answer::empty(status);
            }
        };
        let body = match timeout(BODY_TIME, Limited::new(body, passed.length).collect()).await {
            Ok(Ok(body)) => body.to_bytes(),
            Ok(Err(_)) => return answer::empty(StatusCode::BAD_REQUEST),
            Err(_) => return answer::empty(StatusCode::REQUEST_TIMEOUT),
        };
        let Ok(_place) = self.answered.try_acquire() else {
            return answer::empty(StatusCode::SERVICE_UNAVAILABLE);
        };
        let service = Arc::clone(&self.service);
        let answered = spawn_blocking(move || service::answer(&*service, &passed, &body));
        answered
            .await
            .unwrap_or_else(|_| answer::empty(StatusCode::INTERNAL_SERVER_ERROR))
    }
}

/// Takes a little of what still comes: where a connection is closed on unread bytes, the answer is lost on its way.
async fn drain(mut body: Incoming) {
    let rest = async { while let Some(Ok(_)) = body.frame().await {} };
    let _ = timeout(LOOK, rest).await;
}

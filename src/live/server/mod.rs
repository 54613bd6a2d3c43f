//! The page of a desk, or of frames, for a browser on the same machine: HTTP on 127.0.0.1, behind a token, guarded against other hosts and pages.
//!
//! hyper, the server of axum, holds the connections, as tiny_http 0.12 cannot limit the time in which one sends its request. axum
//! itself would add its router: here every path is one line of a `match`.

mod answer;

mod door;

mod guard;

mod marking_routes;

mod routes;

mod service;

mod token;

use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::sync::Arc;

use crate::progress::Progress;

use super::desk::Desk;
use super::marking::Marking;
use door::Door;
use guard::Guard;
use marking_routes::MarkingRoutes;
use routes::Routes;
pub use service::Page;
use token::Token;

/// A server that listens, and serves nobody yet.
pub struct Server {
    listener: TcpListener,
    guard: Guard,
    port: u16,
}

impl Server {
    /// Listens on a port of 127.0.0.1; 0: any that is free.
    ///
    /// # Errors
    /// If the port is taken, or the system gives no random numbers.
    pub fn bind(port: u16) -> io::Result<Server> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let port = listener.local_addr()?.port();
        let guard = Guard::new(Token::random()?, port);
        Ok(Server {
            listener,
            guard,
            port,
        })
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.guard.token().text())
    }

    /// Serves a desk until `stop` is cancelled.
    ///
    /// # Errors
    /// If the system gives no thread, or the listener cannot be waited for.
    pub fn serve(self, desk: &Arc<Desk>, page: Page, stop: &Progress) -> io::Result<()> {
        let routes = Routes::new(Arc::clone(desk), page);
        Door::new(self.guard, Arc::new(routes)).serve(self.listener, stop)
    }

    /// Serves frames to be marked until `stop` is cancelled.
    ///
    /// # Errors
    /// If the system gives no thread, or the listener cannot be waited for.
    pub fn serve_frames(self, marking: Arc<Marking>, page: Page, stop: &Progress) -> io::Result<()> {
        let routes = MarkingRoutes::new(marking, page);
        Door::new(self.guard, Arc::new(routes)).serve(self.listener, stop)
    }
}

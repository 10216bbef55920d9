//! Beyond the seed: the session service over the reference backend.

use std::ffi::c_char;

use ncp_spec::session::{ReferenceBackend, SessionService};

use crate::abi::{Handle, bytes, entry, required, text_out};

/// Serves sessions. One thread at a time may use it.
pub struct Service(Handle<SessionService<ReferenceBackend>>);

/// A service without sessions, over the reference backend.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_service_new() -> Option<Box<Service>> {
    entry(|| {
        let service = SessionService::new(ReferenceBackend);
        Ok(Some(Box::new(Service(Handle::new(service)))))
    })
}

/// The one reply to a request, whatever its bytes. NULL only if the service itself is at fault.
///
/// # Safety
/// The request has that many bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ncp_service_serve(
    service: Option<&mut Service>,
    request: *const u8,
    request_len: usize,
) -> *mut c_char {
    entry(|| {
        let Service(service) = required(service, "service")?;
        // SAFETY: as this function demands.
        let request = unsafe { bytes(request, request_len, "request")? };
        service.with(|service| text_out(service.serve(request)))
    })
}

/// Frees a service and its sessions. NULL is nothing.
#[unsafe(no_mangle)]
pub extern "C" fn ncp_service_free(service: Option<Box<Service>>) {
    entry(|| {
        drop(service);
        Ok(())
    });
}

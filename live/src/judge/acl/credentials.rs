//! Certificates: those of a throw-away authority, or a deployment's own.

use std::fs;
use std::path::{Path, PathBuf};

use ncp_zenoh::{BusError, Link};
use rcgen::{BasicConstraints, CertificateParams, DnType, IsCa, Issuer, KeyPair};
use serde_json::json;
use zenoh::Config;

use crate::LiveError;

/// Where a certificate for each identity is: `{name}.pem` and `{name}.key` in a folder, and the authority's.
#[derive(Debug, Clone)]
pub(crate) struct Credentials {
    /// The authority's certificate.
    pub(crate) authority: PathBuf,
    /// The folder.
    pub(crate) folder: PathBuf,
}

impl Credentials {
    /// A certificate for each, of a throw-away authority; that of the foreigner is of another, which nobody trusts.
    ///
    /// # Errors
    /// They cannot be made or written.
    pub(super) fn throw_away(folder: &Path) -> Result<Self, LiveError> {
        certificates(folder)?;
        Ok(Self { authority: folder.join("authority.pem"), folder: folder.to_owned() })
    }

    /// Zenoh's configuration of one who connects.
    ///
    /// # Errors
    /// Zenoh refuses the endpoint.
    pub(super) fn client(&self, endpoint: &str, who: &str) -> Result<Config, LiveError> {
        let mut config = Link::Connect(endpoint.to_owned()).config()?;
        config.insert_json5("transport/link/tls", &self.tls(who, "connect")).map_err(BusError::from)?;
        config.insert_json5("connect/timeout_ms", "3000").map_err(BusError::from)?;
        Ok(config)
    }

    /// Zenoh's configuration of the router, with access rules.
    ///
    /// # Errors
    /// Zenoh refuses the rules.
    pub(super) fn router(&self, endpoint: &str, rules: &str) -> Result<Config, LiveError> {
        let mut config = Link::Router(endpoint.to_owned()).config()?;
        config.insert_json5("transport/link/tls", &self.tls("router", "listen")).map_err(BusError::from)?;
        config.insert_json5("access_control", rules).map_err(BusError::from)?;
        Ok(config)
    }

    /// Whether there is a certificate for somebody; `nobody` needs none.
    pub(super) fn has(&self, who: &str) -> bool {
        who == "nobody" || self.folder.join(format!("{who}.pem")).is_file()
    }

    fn tls(&self, who: &str, side: &str) -> String {
        let file = |name: String| self.folder.join(name).to_string_lossy().into_owned();
        let mut tls = json!({ "root_ca_certificate": self.authority.to_string_lossy() });
        if who != "nobody" {
            tls["enable_mtls"] = json!(true);
            tls[format!("{side}_certificate")] = json!(file(format!("{who}.pem")));
            tls[format!("{side}_private_key")] = json!(file(format!("{who}.key")));
        }
        tls.to_string()
    }
}

fn certificates(folder: &Path) -> Result<(), LiveError> {
    let authority = |name: &str| -> Result<(Issuer<'static, KeyPair>, String), rcgen::Error> {
        let mut params = CertificateParams::new(Vec::<String>::new())?;
        params.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
        params.distinguished_name.push(DnType::CommonName, name);
        let key = KeyPair::generate()?;
        let pem = params.self_signed(&key)?.pem();
        Ok((Issuer::new(params, key), pem))
    };
    let (own, pem) = authority("throw-away authority")?;
    let (other, _) = authority("another authority")?;
    fs::write(folder.join("authority.pem"), pem)?;
    for name in ["router", "commander", "robot", "observer", "stranger", "foreigner"] {
        let mut params = CertificateParams::new(["localhost", "127.0.0.1"].map(str::to_owned))?;
        // A foreigner says that he is the commander.
        params.distinguished_name.push(DnType::CommonName, if name == "foreigner" { "commander" } else { name });
        let key = KeyPair::generate()?;
        let issuer = if name == "foreigner" { &other } else { &own };
        fs::write(folder.join(format!("{name}.pem")), params.signed_by(&key, issuer)?.pem())?;
        fs::write(folder.join(format!("{name}.key")), key.serialize_pem())?;
    }
    Ok(())
}

"""What a test report states beside the numbers: who tested, with what, under what conditions."""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class LoadCell:
    """A force transducer.

    Parameters
    ----------
    make, serial
        Maker and type, and serial number.
    accuracy
        Its class or calibration uncertainty as the certificate says it: ``class 0.5, ISO 7500-1``.
    calibrated
        Date of its calibration.
    certificate
        Number of the certificate.
    """

    make: str = ""
    serial: str = ""
    accuracy: str = ""
    calibrated: str = ""
    certificate: str = ""

    @property
    def device(self) -> str:
        """Make and serial number, in a line."""
        return ", ".join(p for p in (self.make, self.serial and f"serial {self.serial}") if p)

    @property
    def calibration(self) -> str:
        """Accuracy, date and certificate, in a line."""
        certificate = self.certificate and f"certificate {self.certificate}"
        return ", ".join(p for p in (self.accuracy, self.calibrated, certificate) if p)


@dataclass(frozen=True, kw_only=True)
class ReportHead:
    """Title block and signatures of a test report.

    Parameters
    ----------
    laboratory, number, customer
        Who reports, under what number, to whom.
    tested_by, checked_by
        Who signs.
    """

    laboratory: str = ""
    number: str = ""
    customer: str = ""
    tested_by: str = ""
    checked_by: str = ""

    @property
    def source(self) -> str:
        """The report as the source of a number: laboratory, then report number."""
        named = f"report {self.number}" if self.number else ""
        return ", ".join(part for part in (self.laboratory, named) if part)

using System;

namespace FastPoints
{
    /// <summary>The origin of GPS times: times of two kinds cannot be mixed.</summary>
    internal enum GpsTimeKind
    {
        Unknown,

        Week, // Seconds of the GPS week.

        AdjustedStandard, // Seconds since 1980-01-06, less 10^9.

        Offset, // Seconds since 1980-01-06, less an offset that the file names (LAS 1.5).
    }

    /// <summary>The kind of a source's GPS times, as LAS has it in bits 0 and 6 of the global encoding.</summary>
    internal readonly struct GpsTime : IEquatable<GpsTime>
    {
        public readonly GpsTimeKind Kind;
        public readonly int OffsetMegaseconds; // For times with an offset, in millions of seconds.

        public GpsTime(GpsTimeKind kind, int offsetMegaseconds = 0)
        {
            Kind = kind;
            OffsetMegaseconds = kind == GpsTimeKind.Offset ? offsetMegaseconds : 0;
        }

        public bool Equals(GpsTime other) => Kind == other.Kind && OffsetMegaseconds == other.OffsetMegaseconds;

        public override string ToString() => Kind switch
        {
            GpsTimeKind.Week => "seconds of the GPS week",
            GpsTimeKind.AdjustedStandard => "adjusted standard GPS time",
            GpsTimeKind.Offset => "GPS time less " + OffsetMegaseconds + " million seconds",
            _ => "GPS time of unknown kind",
        };
    }
}

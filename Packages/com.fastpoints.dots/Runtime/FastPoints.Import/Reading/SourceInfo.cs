using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    /// <summary>A file's description of itself, read from its header without touching the points. These are claims, not
    /// statistics.</summary>
    public sealed class SourceInfo
    {
        public string Path;
        public long FileBytes;

        // The path for messages: an address without what signs it.
        internal string ShownPath => SourcePath.WithoutQuery(Path);
        internal ulong HeadHash; // Hash of its first bytes: tells files of one name and length apart.

        /// <summary>The name of the format: "LAS", "PLY", ...</summary>
        public string Format;

        /// <summary>The format's own version, "1.4" for example.</summary>
        public string Version;

        /// <summary>LAS point data format, or -1.</summary>
        public int PointFormat = -1;

        /// <summary>Bytes of one record, or 0 if records have no fixed length.</summary>
        public int RecordBytes;

        /// <summary>Points according to the header. Unsigned, because a header may claim anything.</summary>
        public ulong PointsClaimed;

        /// <summary>Whether there is such a claim: text files mostly have none.</summary>
        public bool HasPointsClaimed = true;

        /// <summary>Points that the file's real size has room for, at most <see cref="PointsClaimed"/>; -1 if only a scan can
        /// tell.</summary>
        public long PointsReadable = -1;

        /// <summary>Points read so far that the file itself marks as invalid: they are left out, and none is lost.</summary>
        internal long PointsMarkedInvalid;

        public bool HasBoundsClaimed;
        public BoundsGeo BoundsClaimed = BoundsGeo.Empty;

        /// <summary>The bounds claimed, where they can be true; otherwise empty.</summary>
        internal BoundsGeo BoundsIfFinite => HasBoundsClaimed && BoundsClaimed.IsFinite ? BoundsClaimed : BoundsGeo.Empty;

        public PositionTransform Transform = PositionTransform.Identity;

        /// <summary>The attributes of each point.</summary>
        public PointSchema Schema;

        internal string[] ExtraSampledAttributes = Array.Empty<string>();

        public CoordinateSystem Crs = new CoordinateSystem();

        internal bool IsCrsOverridden;
        internal bool IsUnitOverridden;
        internal GpsTime GpsTime; // Unknown if there are no GPS times.

        /// <summary>Where each scan was made, in the order of its number in PointSourceId (0, 0, 0 for those that are left out),
        /// or where the only one was; null if that is not known.</summary>
        internal double3[] Scanners;
        internal string Conflict; // Why the files cannot be one cloud; null if they can. Each can still be inspected.

        internal void ThrowIfInConflict()
        {
            if (Conflict != null)
                throw new PointCloudException(FailureCode.Unsupported, Path, -1, Conflict);
        }

        /// <summary>Everything else that the header says, as readable lines: name and value, in the file's order.</summary>
        public readonly List<KeyValuePair<string, string>> Facts = new List<KeyValuePair<string, string>>();

        public readonly List<CloudWarning> Warnings = new List<CloudWarning>();

        internal readonly List<Loss> Losses = new List<Loss>();

        public void AddFact(string name, string value) => Facts.Add(new KeyValuePair<string, string>(name, value));

        internal void AddFactIfAny(string name, string value)
        {
            if (!string.IsNullOrEmpty(value))
                AddFact(name, value);
        }

        internal string UnexportableFacts; // Comments, poses: facts that no exported format can hold; null if there are none.

        public void Warn(long byteOffset, string text) => Warnings.Add(new CloudWarning(Path, byteOffset, text));
    }

    // One warning, at the first reported byte, whose count grows while blocks are read.
    internal sealed class RunningWarning
    {
        int m_index = -1;
        long m_count;

        public void Add(SourceInfo info, long count, long byteOffset, Func<string, string> text)
        {
            if (m_index < 0)
            {
                m_index = info.Warnings.Count;
                info.Warn(byteOffset, "");
            }
            m_count += count;
            var first = info.Warnings[m_index];
            info.Warnings[m_index] = new CloudWarning(first.Path, first.ByteOffset, text(NumberText.Of(m_count)));
        }

        public void Reset() => m_count = 0;
    }

    /// <summary>The coordinate reference system as far as the file names it. It is kept and shown, but never used to move
    /// points.</summary>
    public sealed class CoordinateSystem
    {
        /// <summary>OGC well-known text, or null.</summary>
        public string Wkt;

        /// <summary>EPSG code of the horizontal (or compound) system, or 0.</summary>
        public int Epsg;

        /// <summary>EPSG code of the vertical system, or 0.</summary>
        public int VerticalEpsg;

        /// <summary>The system's readable name, or null.</summary>
        public string Name;

        /// <summary>Metres of one horizontal unit (0.3048 for feet); 0 if unknown; NaN for degrees.</summary>
        public double MetresPerUnit;

        /// <summary>Metres of one vertical unit; 0 if nothing says it.</summary>
        public double VerticalMetresPerUnit;

        public CloudUnits Units => new CloudUnits(MetresPerUnit, VerticalMetresPerUnit);

        internal CrsKind Kind;

        /// <summary>The order of axes that EPSG's table gives, a letter each (east, north, up); null if unknown. Coordinates are
        /// never swapped for it.</summary>
        internal string Axes;

        /// <summary>GeoTIFF keys as a LAS file has them, its directory, doubles and text as bytes; null without keys.</summary>
        internal byte[][] GeoKeys;

        public CloudCrs ToCloudCrs() => new CloudCrs
        {
            Name = Summary,
            Wkt = Wkt,
            Epsg = Epsg,
            VerticalEpsg = VerticalEpsg,
            MetresPerUnit = MetresPerUnit,
            VerticalMetresPerUnit = VerticalMetresPerUnit,
            GeoKeys = GeoKeys,
        };

        internal bool HasSameCodes(CoordinateSystem other)
        {
            bool isSame = Wkt == other.Wkt && Epsg == other.Epsg && VerticalEpsg == other.VerticalEpsg &&
                GeoKeys == null == (other.GeoKeys == null);
            for (int i = 0; isSame && i < GeoKeys?.Length; i++)
                isSame = GeoKeys[i].AsSpan().SequenceEqual(other.GeoKeys[i]);
            return isSame;
        }

        public bool IsKnown => Wkt != null || Epsg != 0 || Name != null;

        /// <summary>Name and EPSG code in one line; null if nothing is known.</summary>
        public string Summary
        {
            get
            {
                string code = Epsg != 0 ? "EPSG:" + Epsg + (VerticalEpsg != 0 ? "+" + VerticalEpsg : "") : null;
                if (Name != null)
                    return code != null ? Name + " (" + code + ")" : Name;
                return code ?? (Wkt != null ? "WKT without a name" : null);
            }
        }
    }

    internal enum CrsKind
    {
        Unknown,
        Projected,
        Geographic,
        Geocentric,
        Local,
        Vertical,
    }

    /// <summary>Something in a source that the target format cannot hold.</summary>
    internal readonly struct Loss
    {
        public readonly string What;

        public readonly string Where;
        public readonly string Reason;

        public Loss(string what, string where, string reason) =>
            (What, Where, Reason) = (what, SourcePath.WithoutQuery(where), reason);

        public override string ToString() => Where + ": " + What + ": lost, since " + Reason;
    }
}

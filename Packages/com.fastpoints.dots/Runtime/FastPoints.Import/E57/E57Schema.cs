using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace FastPoints.E57
{
    // The one schema of a file whose scans may differ. A position is an int32 or int64 on a common grid where all scans are
    // scaled integers on one (exact), a float where they are floats that no pose moves, and a double otherwise. An attribute has
    // the smallest type that holds it in all scans; a scan without it has 0.
    sealed class E57Schema
    {
        enum PositionKind
        {
            Grid,
            Floats,
            Doubles,
        }

        const double GridToleranceSteps = 1e-6; // Less than this share of a step counts as rounding of decimal scales.

        const double MaxNormalized = 65535;

        readonly List<E57Scan> m_scans;
        PositionKind m_positions;

        // For grid positions, by scan and axis: grid steps in one of the scan's steps, and what is added then.
        long[][] m_factorsOfScan;
        long[][] m_shiftsOfScan;
        readonly AttributeType[] m_gridTypes = new AttributeType[3];
        readonly Dictionary<string, string> m_fieldOf = new Dictionary<string, string>();

        public E57Schema(List<E57Scan> scans)
        {
            m_scans = scans;
            var attributes = new List<PointAttribute>();
            ChoosePositions();
            attributes.Add(new PointAttribute(AttributeNames.X, PositionType(0)));
            attributes.Add(new PointAttribute(AttributeNames.Y, PositionType(1)));
            attributes.Add(new PointAttribute(AttributeNames.Z, PositionType(2)));
            foreach (string field in FieldNames())
                attributes.Add(new PointAttribute(E57Names.AttributeOf(field), TypeOf(field, out double scale, out double offset),
                    scale, offset));
            if (scans.Count > 1 && !m_fieldOf.ContainsKey(AttributeNames.PointSourceId))
                attributes.Add(new PointAttribute(AttributeNames.PointSourceId,
                    scans.Count < ushort.MaxValue ? AttributeType.UInt16 : AttributeType.UInt32));
            Schema = new PointSchema(attributes);
        }

        public PointSchema Schema { get; }

        // Null unless all are known, and the scan of each point.
        public double3[] Scanners
        {
            get
            {
                bool isOne = m_scans.Count == 1;
                if (m_scans.Count == 0 || !m_scans.TrueForAll(s => s.IsScannerKnown) ||
                    !isOne && m_fieldOf.ContainsKey(AttributeNames.PointSourceId))
                    return null;
                var scanners = new double3[isOne ? 1 : 1 + m_scans.Max(s => s.Index)];
                foreach (var scan in m_scans)
                    scanners[isOne ? 0 : scan.Index] = scan.Pose.Translation;
                return scanners;
            }
        }

        public PositionTransform Transform { get; private set; } = PositionTransform.Identity;
        public string PositionSummary { get; private set; }

        // Fields whose names belong to other attributes, or that exceed the limit.
        public List<string> LeftOut { get; } = new List<string>();

        public bool HasVectorPositions => m_positions == PositionKind.Doubles;

        // Normals that are rotated with their scan pass through rows of doubles.
        public static bool HasRotatedNormals(E57Scan scan) =>
            !scan.Pose.IsTranslation && scan.FindTriple(E57Names.Normals) != null;

        public List<E57FieldRead> ReadsOf(int scanIndex, PointBatch batch)
        {
            var scan = m_scans[scanIndex];
            var reads = new List<E57FieldRead>();
            var wanted = batch.Schema;
            AddInvalid(reads, scan.Field(scan.IsCartesian ? E57Names.CartesianInvalid : E57Names.SphericalInvalid));
            bool needsPosition = wanted.Has(AttributeNames.X) || wanted.Has(AttributeNames.Y) || wanted.Has(AttributeNames.Z);
            var position = scan.FindTriple(scan.IsCartesian ? E57Names.Cartesian : E57Names.Spherical);
            if (HasVectorPositions && needsPosition)
                for (int i = 0; i < 3; i++)
                    reads.Add(VectorRead(position[i], i));
            bool hasRotatedNormals = HasRotatedNormals(scan);
            bool hasReadNormals = false;
            for (int i = 0; i < wanted.Count; i++)
            {
                string name = wanted[i].Name;
                int axis = AttributeNames.AxisOf(name);
                if (axis >= 0)
                {
                    if (HasVectorPositions)
                        continue;
                    var direct = Read(position[axis], batch, i);
                    if (m_positions == PositionKind.Grid)
                    {
                        direct.Factor = m_factorsOfScan[scanIndex][axis];
                        direct.Shift = m_shiftsOfScan[scanIndex][axis];
                    }
                    reads.Add(direct);
                    continue;
                }
                var field = FieldOf(scan, name);
                if (hasRotatedNormals && field != null && Array.IndexOf(E57Names.Normals, field.Name) >= 0)
                {
                    if (!hasReadNormals)
                        for (int row = 0; row < 3; row++)
                            reads.Add(VectorRead(scan.Field(E57Names.Normals[row]), 3 + row));
                    hasReadNormals = true;
                    continue;
                }
                if (name == AttributeNames.PointSourceId && field == null)
                    reads.Add(Constant(scan.Index + 1, batch, i));
                else if (field == null)
                    reads.Add(Constant(0, batch, i));
                else
                    reads.Add(ReadAs(scan, field, batch, i));
            }
            return reads;
        }

        // Colours that are neither bytes, 16-bit numbers nor from 0 to 1 become 16-bit numbers.
        public bool HasScaledColors { get; private set; }

        void ChoosePositions()
        {
            if (m_scans.Count > 0 && TryGrid())
            {
                m_positions = PositionKind.Grid;
                PositionSummary = Array.TrueForAll(m_factorsOfScan, factors => Array.TrueForAll(factors, factor => factor == 1))
                    ? "whole numbers, as stored" : "whole numbers of several scales, on one grid that holds all exactly";
            }
            else if (m_scans.TrueForAll(scan => scan.IsCartesian && scan.Pose.IsIdentity &&
                Array.TrueForAll(scan.FindTriple(E57Names.Cartesian), field => field.Kind == E57FieldKind.Float32)))
            {
                m_positions = PositionKind.Floats;
                PositionSummary = "floats, as stored";
            }
            else
            {
                m_positions = PositionKind.Doubles;
                PositionSummary = m_scans.TrueForAll(scan => scan.IsCartesian && scan.Pose.IsIdentity)
                    ? "doubles" : "doubles, computed from the scans' coordinates and poses";
            }
        }

        AttributeType PositionType(int axis) => m_positions == PositionKind.Grid ? m_gridTypes[axis]
            : m_positions == PositionKind.Floats ? AttributeType.Float32 : AttributeType.Float64;

        // Factors are integers, shifts whole steps.
        bool TryGrid()
        {
            var factors = new long[m_scans.Count][];
            var shifts = new long[m_scans.Count][];
            for (int i = 0; i < shifts.Length; i++)
            {
                factors[i] = new long[3];
                shifts[i] = new long[3];
            }
            var scales = new double[m_scans.Count];
            var offsets = new double[m_scans.Count];
            double3 scale = default, offset = default;
            for (int axis = 0; axis < 3; axis++)
            {
                for (int i = 0; i < m_scans.Count; i++)
                {
                    var scan = m_scans[i];
                    var field = scan.IsCartesian ? scan.Field(E57Names.Cartesian[axis]) : null;
                    if (field == null || !field.IsInteger || !scan.Pose.IsTranslation)
                        return false;
                    scales[i] = field.Scale;
                    offsets[i] = field.Offset + scan.Pose.Translation[axis];
                }
                bool isOneScale = Array.TrueForAll(scales, other => other == scales[0]);
                scale[axis] = isOneScale ? scales[0] : CommonGrid.StepOf(scales, offsets);
                offset[axis] = offsets[0];
                double min = double.PositiveInfinity, max = double.NegativeInfinity;
                for (int i = 0; i < m_scans.Count; i++)
                {
                    double steps = (offsets[i] - offset[axis]) / scale[axis];
                    if (!CommonGrid.TryRescale(scales[i], offsets[i], scale[axis], offset[axis], out var placed) ||
                        placed.Loss > 0 || !(Math.Abs(steps - placed.Shift) <= GridToleranceSteps) ||
                        Math.Abs(placed.Shift) > uint.MaxValue)
                        return false;
                    var (factor, whole, _) = placed;
                    factors[i][axis] = factor;
                    shifts[i][axis] = whole;
                    var field = m_scans[i].Field(E57Names.Cartesian[axis]);
                    double first = (double)field.Minimum * factor + whole, last = (double)field.Maximum * factor + whole;
                    min = Math.Min(min, Math.Min(first, last));
                    max = Math.Max(max, Math.Max(first, last));
                }
                // Doubles round these limits, but only far outside of 64 bits.
                bool isMoved = !isOneScale || shifts.Any(shift => shift[axis] != 0);
                if (isMoved && !(Math.Abs(min) < 1L << 62 && Math.Abs(max) < 1L << 62))
                    return false;
                bool isNarrow = max - min <= uint.MaxValue && Math.Abs(min) < 1L << 52;
                m_gridTypes[axis] = isNarrow ? AttributeType.Int32 : AttributeType.Int64;
                if (!isNarrow || min >= int.MinValue && max <= int.MaxValue)
                    continue;
                long toInt = int.MinValue - (long)min;
                for (int i = 0; i < shifts.Length; i++)
                    shifts[i][axis] += toInt;
                offset[axis] -= toInt * scale[axis];
            }
            m_factorsOfScan = factors;
            m_shiftsOfScan = shifts;
            Transform = new PositionTransform { Scale = scale, Offset = offset };
            return true;
        }

        List<string> FieldNames()
        {
            var names = new List<string>();
            var known = new HashSet<string>(E57Names.Cartesian);
            known.Add(E57Names.CartesianInvalid);
            known.Add(E57Names.SphericalInvalid);
            foreach (var scan in m_scans)
                foreach (var field in scan.Fields)
                {
                    bool isPosition = !scan.IsCartesian && Array.IndexOf(E57Names.Spherical, field.Name) >= 0;
                    if (field.Kind == E57FieldKind.String || isPosition || !known.Add(field.Name))
                        continue;
                    string attribute = E57Names.AttributeOf(field.Name);
                    if (attribute.Length == 1 && "XYZ".Contains(attribute) || m_fieldOf.ContainsKey(attribute) ||
                        names.Count == E57Scan.MaxFields)
                    {
                        LeftOut.Add(field.Name);
                        continue;
                    }
                    m_fieldOf.Add(attribute, field.Name);
                    names.Add(field.Name);
                }
            return names;
        }

        E57Field FieldOf(E57Scan scan, string attribute)
        {
            var field = m_fieldOf.TryGetValue(attribute, out string name) ? scan.Field(name) : null;
            return field == null || field.Kind == E57FieldKind.String ? null : field;
        }

        AttributeType TypeOf(string name, out double scale, out double offset)
        {
            scale = 1;
            offset = 0;
            if (Array.IndexOf(E57Names.Colors, name) >= 0)
                return ColorType();
            bool isFirst = true, isInteger = true, isRotated = false, isFloat32 = true, isOnOneScale = true;
            long min = 0, max = 0;
            foreach (var scan in m_scans)
            {
                var field = scan.Field(name);
                if (field == null || field.Kind == E57FieldKind.String)
                    continue;
                isRotated |= Array.IndexOf(E57Names.Normals, name) >= 0 && HasRotatedNormals(scan);
                isInteger &= field.IsInteger;
                isFloat32 &= field.Kind == E57FieldKind.Float32;
                if (!field.IsInteger)
                    continue;
                if (isFirst)
                {
                    scale = field.Scale;
                    offset = field.Offset;
                }
                isFirst = false;
                isOnOneScale &= field.Scale == scale && field.Offset == offset;
                long bias = BiasOf(field);
                min = Math.Min(min, field.Minimum + bias);
                max = Math.Max(max, field.Maximum == long.MaxValue ? long.MaxValue : field.Maximum + bias);
            }
            if (isInteger && isOnOneScale && !isRotated)
                return TypeOf(min, max);
            scale = 1;
            offset = 0;
            return isFloat32 || isRotated ? AttributeType.Float32 : AttributeType.Float64;
        }

        // E57 counts returns from 0, all others from 1.
        static long BiasOf(E57Field field) => field.Name == E57Names.ReturnIndex && !field.IsScaled ? 1 : 0;

        static AttributeType TypeOf(long min, long max)
        {
            if (min >= 0)
                return max <= byte.MaxValue ? AttributeType.UInt8 : max <= ushort.MaxValue ? AttributeType.UInt16
                    : max <= uint.MaxValue ? AttributeType.UInt32 : AttributeType.Int64;
            return min >= sbyte.MinValue && max <= sbyte.MaxValue ? AttributeType.Int8
                : min >= short.MinValue && max <= short.MaxValue ? AttributeType.Int16
                : min >= int.MinValue && max <= int.MaxValue ? AttributeType.Int32 : AttributeType.Int64;
        }

        AttributeType ColorType()
        {
            bool areBytes = true, areShorts = true, areNormalized = true, areFloats = true;
            foreach (var scan in m_scans)
                for (int i = 0; i < 3; i++)
                {
                    var field = scan.Field(E57Names.Colors[i]);
                    if (field == null || field.Kind == E57FieldKind.String)
                        continue;
                    var limits = ColorLimits(scan, i, field);
                    bool isWhole = field.IsInteger && !field.IsScaled && limits.x == 0;
                    areBytes &= isWhole && field.Maximum <= byte.MaxValue;
                    areShorts &= isWhole && field.Maximum <= ushort.MaxValue && limits.y == ushort.MaxValue;
                    areNormalized &= !field.IsInteger && limits.x == 0 && limits.y == 1;
                    areFloats &= field.Kind == E57FieldKind.Float32;
                }
            HasScaledColors = !areBytes && !areShorts && !areNormalized;
            return areBytes ? AttributeType.UInt8 : !areNormalized ? AttributeType.UInt16
                : areFloats ? AttributeType.Float32 : AttributeType.Float64;
        }

        // The values for none and all of a colour. Some writers give the smallest and the largest value that occurs: limits are
        // widened to 0 and to all ones, so that colours keep their balance.
        static double2 ColorLimits(E57Scan scan, int color, E57Field field)
        {
            var limits = scan.ColorLimits[color];
            if (!(math.all(math.isfinite(limits)) && limits.x < limits.y))
                limits = !field.IsInteger || field.Bits <= 32
                    ? new double2(field.MinReal, field.MaxReal) : new double2(double.NaN, double.NaN);
            if (!(limits.x < limits.y && math.all(math.abs(limits) < uint.MaxValue + 1.0)))
                limits = new double2(0, field.IsInteger ? byte.MaxValue : 1);
            double full = 1;
            while (full < limits.y)
                full = full * 2 + 1;
            return new double2(Math.Min(0, limits.x), full);
        }

        static void AddInvalid(List<E57FieldRead> reads, E57Field field)
        {
            if (field == null || field.Kind == E57FieldKind.String)
                return;
            var read = Source(field);
            read.Target = E57Target.InvalidFlag;
            reads.Add(read);
        }

        E57FieldRead ReadAs(E57Scan scan, E57Field field, PointBatch batch, int column)
        {
            var read = Read(field, batch, column);
            int color = Array.IndexOf(E57Names.Colors, field.Name);
            if (color >= 0 && HasScaledColors)
            {
                var limits = ColorLimits(scan, color, field);
                double factor = MaxNormalized / (limits.y - limits.x);
                read.Target = E57Target.To16Bits;
                read.Offset = (read.Offset - limits.x) * factor;
                read.Scale *= factor;
            }
            return read;
        }

        static E57FieldRead VectorRead(E57Field field, int row)
        {
            var read = Source(field);
            read.Target = E57Target.Vector;
            read.Row = row;
            return read;
        }

        static E57FieldRead Read(E57Field field, PointBatch batch, int column)
        {
            var read = Source(field);
            read.ColumnType = batch.Schema[column].Type;
            read.ColumnOffsetBytes = batch.Column(column).OffsetBytes;
            read.Target = read.ColumnType.IsFloat() ? E57Target.Reals : E57Target.Integers;
            read.Shift = read.Target == E57Target.Integers ? BiasOf(field) : 0;
            read.Offset += read.Target == E57Target.Reals ? BiasOf(field) : 0;
            return read;
        }

        static E57FieldRead Constant(long value, PointBatch batch, int column) => new E57FieldRead
        {
            Kind = E57FieldKind.Integer,
            Stream = -1,
            Minimum = value,
            Factor = 1,
            ColumnType = batch.Schema[column].Type,
            ColumnOffsetBytes = batch.Column(column).OffsetBytes,
            Target = batch.Schema[column].Type.IsFloat() ? E57Target.Reals : E57Target.Integers,
            Scale = 1,
        };

        static E57FieldRead Source(E57Field field) => new E57FieldRead
        {
            Kind = field.Kind,
            Stream = field.Stream,
            Bits = field.Bits,
            Minimum = field.Minimum,
            Factor = 1,
            Range = (ulong)field.Maximum - (ulong)field.Minimum,
            Scale = field.Scale,
            Offset = field.Offset,
        };
    }
}

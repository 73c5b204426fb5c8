using FastPoints.Reading;
using FastPoints.Streaming;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>A slice of a block: chooses points, and appends them as records to the buffers, each behind the last of the slice
    /// before; or only measures where the chosen points are.</summary>
    [BurstCompile]
    internal unsafe struct MakeRecordsJob : IJob
    {
        public const int PointsPerSlice = 8192; // Points of a slice: below a millisecond for most records.
        public NativeArray<byte> Columns; // Of the block's batch; the chosen points move to the front of the slice.
        [ReadOnly] public NativeReference<DecodeResult> Decoded;
        public PositionColumns Positions;
        [ReadOnly] public NativeArray<PointColumn> AllColumns;

        [ReadOnly] public NativeArray<FieldCopy> Copies;
        [ReadOnly] public NativeArray<FieldCopy> ConvertedCopies;
        [ReadOnly] public NativeArray<ColumnConversion> Conversions;
        public NativeArray<byte> Converted; // Columns of a slice: x, y, z of 8 bytes each, then one for each conversion.
        public NativeArray<int> Chosen;
        [ReadOnly] public NativeArray<LocalClip> Clips;
        [ReadOnly] public NativeArray<ulong> Classes; // The classes that are wanted, a bit each; empty for all.
        public PointColumn Classification;

        public double Fraction;
        public PositionConversion Position;
        [ReadOnly] public NativeArray<ulong> Buffers; // Where each buffer begins, in turn; empty to measure.
        public int BufferPoints;
        public int RecordBytes;
        public int ReturnMask; // Bits of the byte at 14 that are the return number; 0 where records are not those of LAS.
        public int TimeAt; // Where a record has its GPS time; 0 if its range is not wanted.
        public long FirstRecord; // The first record of the range's node in the buffers; 0 without nodes.

        public double3 MinPosition;
        public double3 MaxPosition;
        public NativeReference<ExportState> State;
        public NativeReference<long> End; // Where the next record goes, after this job.
        public int First;
        public int Count;

        public void Execute()
        {
            var state = State.Value;
            state.NextRecord = math.max(state.NextRecord, FirstRecord);
            int count = math.min(Count, Decoded.Value.Points - First);
            int chosen = count > 0 ? Choose(count, ref state) : 0;
            if (chosen > 0 && Buffers.Length > 0)
            {
                if (chosen < count)
                    for (int c = 0; c < AllColumns.Length; c++)
                        PointRecords.Gather((byte*)Columns.GetUnsafePtr(), AllColumns[c],
                            (int*)Chosen.GetUnsafeReadOnlyPtr(), chosen, First);
                for (int c = 0; c < Conversions.Length; c++)
                    Convert(Conversions[c], chosen, ref state);
                Append(chosen, ref state);
            }
            State.Value = state;
            End.Value = state.NextRecord;
        }

        /// <summary>Lists the points that are wanted and have a place, and converts their positions if these change.</summary>
        int Choose(int count, ref ExportState state)
        {
            const int run = ColumnValues.BatchLength;
            byte* columns = (byte*)Columns.GetUnsafePtr(), converted = (byte*)Converted.GetUnsafePtr();
            int* chosen = (int*)Chosen.GetUnsafePtr();
            double* x = stackalloc double[run], y = stackalloc double[run], z = stackalloc double[run];
            double* classes = stackalloc double[run];
            bool needsGeo = Clips.Length > 0 || Position.Kind == PositionKind.Rounded || Position.Kind == PositionKind.Geo;
            if (Position.Kind == PositionKind.Copied && Clips.Length == 0 && Classes.Length == 0 && Fraction >= 1)
            {
                state.Seen += count;
                state.Chosen += count;
                return count;
            }
            int done = 0;
            for (int first = 0; first < count; first += run)
            {
                int points = math.min(run, count - first);
                if (needsGeo)
                {
                    Positions.Load(columns, First + first, points, x, y, z);
                    Position.From.ToGeo(points, x, y, z);
                }
                if (Classes.Length > 0)
                    ColumnValues.ToDoubles(columns + Classification.OffsetBytes, Classification.Type, First + first, points,
                        classes);
                for (int i = 0; i < points; i++)
                {
                    state.Seen++;
                    if (Fraction < 1 && math.floor(state.Seen * Fraction) == math.floor((state.Seen - 1) * Fraction))
                        continue;
                    if (Classes.Length > 0 && !IsWanted(classes[i]))
                        continue;
                    var position = needsGeo ? new double3(x[i], y[i], z[i]) : default;
                    if (Clips.Length > 0 && !LocalClip.Keeps((LocalClip*)Clips.GetUnsafeReadOnlyPtr(), Clips.Length, position))
                        continue;
                    if (Position.Kind != PositionKind.Copied &&
                        !ConvertPosition(columns, First + first + i, position, converted, done, ref state))
                        continue;
                    chosen[done++] = First + first + i;
                }
            }
            state.Chosen += done;
            return done;
        }

        bool IsWanted(double c) => c >= 0 && c < 256 && (Classes[(int)c >> 6] >> ((int)c & 63) & 1) != 0;

        /// <returns>Whether the point has a place in the file.</returns>
        bool ConvertPosition(byte* columns, int point, double3 position, byte* converted, int to, ref ExportState state)
        {
            if (Position.Kind == PositionKind.Geo)
            {
                for (int axis = 0; axis < 3; axis++)
                    ((double*)(converted + axis * 8 * PointsPerSlice))[to] = position[axis];
                return true;
            }
            if (Position.Kind == PositionKind.Narrowed)
            {
                var stored = new Grid3(StoredAt(columns, Positions.X, point), StoredAt(columns, Positions.Y, point),
                    StoredAt(columns, Positions.Z, point));
                if (Buffers.Length == 0)
                {
                    state.MinStored = Grid3.Min(state.MinStored, stored);
                    state.MaxStored = Grid3.Max(state.MaxStored, stored);
                    return true;
                }
                var from = stored - Position.Base;
                if (Position.Divisor == 1)
                    return PutPosition(from, converted, to, ref state);
                position = new double3(from.X, from.Y, from.Z) / Position.Divisor;
            }
            else if (!math.all(math.isfinite(position)))
            {
                state.LeftOut++;
                return false;
            }
            else
            {
                state.MinGeo = math.min(state.MinGeo, position);
                state.MaxGeo = math.max(state.MaxGeo, position);
                position = (position - Position.To.Offset) / Position.To.Scale;
            }
            if (Buffers.Length == 0)
                return true;
            var rounded = math.clamp(math.floor(position + 0.5), MinPosition, MaxPosition);
            if (!math.all(rounded >= int.MinValue) || !math.all(rounded <= int.MaxValue))
            {
                state.LeftOut++;
                return false;
            }
            var off = math.abs(rounded - position) * math.abs(Position.To.Scale);
            state.MaxPositionError = math.max(state.MaxPositionError, math.max(off.x, math.max(off.y, off.z)));
            return PutPosition(new Grid3((long)rounded.x, (long)rounded.y, (long)rounded.z), converted, to, ref state);
        }

        // Tiles may have 64 bits along one axis alone.
        static long StoredAt(byte* columns, in PointColumn column, int point) => column.Type == AttributeType.Int64
            ? ((long*)(columns + column.OffsetBytes))[point] : ((int*)(columns + column.OffsetBytes))[point];

        static bool PutPosition(Grid3 position, byte* converted, int to, ref ExportState state)
        {
            int x = (int)position.X, y = (int)position.Y, z = (int)position.Z;
            if (x != position.X || y != position.Y || z != position.Z)
            {
                state.LeftOut++;
                return false;
            }
            ((int*)converted)[to] = x;
            ((int*)(converted + 8 * PointsPerSlice))[to] = y;
            ((int*)(converted + 16 * PointsPerSlice))[to] = z;
            return true;
        }

        void Convert(in ColumnConversion conversion, int chosen, ref ExportState state)
        {
            byte* from = (byte*)Columns.GetUnsafeReadOnlyPtr() + conversion.From.OffsetBytes;
            byte* to = (byte*)Converted.GetUnsafePtr() + conversion.To.OffsetBytes;
            if (conversion.IsClamp && conversion.From.Type == AttributeType.UInt8 &&
                conversion.To.Type == AttributeType.UInt8)
            {
                int max = (int)conversion.Max, clamped = 0;
                for (int i = 0; i < chosen; i++)
                {
                    int value = from[First + i];
                    clamped += value > max ? 1 : 0;
                    to[i] = (byte)math.min(value, max);
                }
                state.Clamped += clamped;
                return;
            }
            double* values = stackalloc double[ColumnValues.BatchLength];
            for (int first = 0; first < chosen; first += ColumnValues.BatchLength)
            {
                int points = math.min(ColumnValues.BatchLength, chosen - first);
                ColumnValues.ToDoubles(from, conversion.From.Type, First + first, points, values);
                for (int i = 0; i < points; i++)
                {
                    double value = values[i] * conversion.Scale + conversion.Offset;
                    if (conversion.Scale != 1)
                        value = math.round(value);
                    if (value > conversion.Max)
                    {
                        value = conversion.Max;
                        state.Clamped++;
                    }
                    ColumnValues.Put(to, conversion.To.Type, first + i, value);
                }
            }
        }

        void Append(int chosen, ref ExportState state)
        {
            for (int done = 0; done < chosen;)
            {
                int at = (int)(state.NextRecord % BufferPoints);
                int points = math.min(chosen - done, BufferPoints - at);
                byte* records = (byte*)Buffers[(int)(state.NextRecord / BufferPoints % Buffers.Length)] +
                    (long)at * RecordBytes;
                UnsafeUtility.MemClear(records, (long)points * RecordBytes);
                PointRecords.FromColumns((byte*)Columns.GetUnsafeReadOnlyPtr(), First + done, points,
                    Copies, records, RecordBytes);
                PointRecords.FromColumns((byte*)Converted.GetUnsafeReadOnlyPtr(), done, points,
                    ConvertedCopies, records, RecordBytes);
                if (ReturnMask != 0)
                    AddStatistics(records, points, ref state);
                state.NextRecord += points;
                state.Written += points;
                done += points;
            }
        }

        void AddStatistics(byte* record, int points, ref ExportState state)
        {
            for (int i = 0; i < points; i++, record += RecordBytes)
            {
                var position = new int3(((int*)record)[0], ((int*)record)[1], ((int*)record)[2]);
                state.Min = math.min(state.Min, position);
                state.Max = math.max(state.Max, position);
                state.ByReturn[record[14] & ReturnMask]++;
                if (TimeAt == 0)
                    continue;
                double time = *(double*)(record + TimeAt);
                state.MinTime = math.min(state.MinTime, time);
                state.MaxTime = math.max(state.MaxTime, time);
            }
        }
    }

    internal enum PositionKind
    {
        Copied,
        Narrowed, // Integers of 64 bits, along some axes perhaps of 32, to those of 32.
        Rounded, // Rounded to a grid of 32-bit integers.
        Geo, // Georeferenced, as doubles.
    }

    internal struct PositionConversion
    {
        public PositionKind Kind;
        public PositionTransform From;
        public PositionTransform To;
        public Grid3 Base; // Of integers: out = (in - Base) / Divisor.
        public double Divisor;
    }

    /// <summary>A column whose values go into records in another type. Blittable.</summary>
    internal struct ColumnConversion
    {
        public PointColumn From;
        public PointColumn To;
        public double Scale;
        public double Offset;
        public double Max; // Larger values become this one, and are counted.

        public bool IsClamp => Scale == 1 && Offset == 0 && Max <= byte.MaxValue;
    }

    internal unsafe struct ExportState
    {
        public long Seen;
        public long Chosen;
        public long Written;

        /// <summary>Where the next record goes: <see cref="Written"/>, and the room that nodes left in their
        /// buffers.</summary>
        public long NextRecord;
        public long LeftOut; // Points whose position is no number, or has no place in the file.
        public long Clamped;
        public double MaxPositionError; // The farthest that a coordinate was moved, in CRS units.
        public Grid3 MinStored;
        public Grid3 MaxStored;
        public double3 MinGeo;
        public double3 MaxGeo;

        public int3 Min;
        public int3 Max;
        public double MinTime;
        public double MaxTime;
        public fixed ulong ByReturn[16];

        public static ExportState None => new ExportState
        {
            MinStored = Grid3.MaxValue,
            MaxStored = Grid3.MinValue,
            MinGeo = BoundsGeo.Empty.Min,
            MaxGeo = BoundsGeo.Empty.Max,
            Min = new int3(int.MaxValue, int.MaxValue, int.MaxValue),
            Max = new int3(int.MinValue, int.MinValue, int.MinValue),
            MinTime = double.PositiveInfinity,
            MaxTime = double.NegativeInfinity,
        };
    }
}

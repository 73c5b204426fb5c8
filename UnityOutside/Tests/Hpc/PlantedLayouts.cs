#pragma warning disable CA1815, CA1823, CS0169, CS0649

namespace UnityOutside.Tests.Hpc;

internal static class PlantedLayouts
{
    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    internal struct Packed
    {
        public byte Tag;
        public int Value;
    }

    [StructLayout(LayoutKind.Auto)]
    internal struct Shuffled
    {
        public byte Tag;
        public int Value;
    }

    [StructLayout(LayoutKind.Sequential, Size = 13)]
    internal struct OddlySized
    {
        public int First;
        public int Second;
    }

    [StructLayout(LayoutKind.Sequential, Size = 64)]
    internal struct Padded
    {
        public int Value;
    }

    [StructLayout(LayoutKind.Explicit, Size = 16)]
    internal unsafe struct Overlaid
    {
        [FieldOffset(0)] public long Whole;
        [FieldOffset(0)] public fixed byte Bytes[16];
    }

    [StructLayout(LayoutKind.Sequential)]
    internal struct Sizeless { }

    internal struct Empty { }

    internal struct MarshalledAsPointer
    {
        [MarshalAs(UnmanagedType.SysInt)] public bool Flag;
    }

    internal struct MarshalledAsByte
    {
        [MarshalAs(UnmanagedType.U1)] public bool Flag;
    }

    internal struct Nested
    {
        public Packed Inner;
    }

    [Planted("field Record is Packed with Pack = 1")]
    [BurstCompile]
    internal struct PackedFieldJob : IJob
    {
        public Packed Record;

        public void Execute() => Record.Value = 1;
    }

    [Planted("is Nested with Inner, Packed with Pack = 1")]
    [BurstCompile]
    internal struct PackedInNestedJob : IJob
    {
        public Nested Record;

        public void Execute() => Record.Inner.Value = 1;
    }

    [Planted("calls SizeOf for Packed with Pack = 1")]
    [BurstCompile]
    internal struct PackedAsArgumentJob : IJob
    {
        public int Size;

        public void Execute() => Size = UnsafeUtility.SizeOf<Packed>();
    }

    [Planted("takes the size of Packed with Pack = 1")]
    [BurstCompile]
    internal unsafe struct PackedSizeJob : IJob
    {
        public int Size;

        public void Execute() => Size = sizeof(Packed);
    }

    [Planted("a variable that is Packed with Pack = 1")]
    [BurstCompile]
    internal struct PackedVariableJob : IJob
    {
        public int Value;

        public void Execute()
        {
            var record = new Packed { Value = Value };
            Value = record.Value + record.Tag;
        }
    }

    [Planted("PackedJob with Pack = 4")]
    [BurstCompile]
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    internal struct PackedJob : IJob
    {
        public int Value;

        public void Execute() => Value++;
    }

    [Planted("field Record is Shuffled with Auto layout")]
    [BurstCompile]
    internal struct AutoLayoutJob : IJob
    {
        public Shuffled Record;

        public void Execute() => Record.Value = 1;
    }

    [Planted]
    [BurstCompile]
    internal struct CapturingJob : IJob
    {
        public int Value;

        public void Execute()
        {
            int by = Value;
            Value = Plus(1);

            int Plus(int x) => x + by;
        }
    }

    [Planted("field Record is OddlySized with Size = 13, no multiple of its alignment, 4")]
    [BurstCompile]
    internal struct OddSizeJob : IJob
    {
        public OddlySized Record;

        public void Execute() => Record.First = 1;
    }

    [Planted("field Record is Sizeless with neither fields nor Size")]
    [BurstCompile]
    internal struct SizelessJob : IJob
    {
        public Sizeless Record;

        public void Execute() => Record = default;
    }

    [Planted("field Record is MarshalledAsPointer with Flag marshalled as IntPtr")]
    [BurstCompile]
    internal struct MarshalledFieldJob : IJob
    {
        public MarshalledAsPointer Record;

        public void Execute() => Record.Flag = true;
    }

    [Planted("field Range is of the type System.ValueTuple`2, whose layout is Auto")]
    [BurstCompile]
    internal struct TupleFieldJob : IJob
    {
        public (int First, int Count) Range;

        public void Execute() => Range = (1, 2);
    }

    [Planted]
    [BurstCompile]
    internal unsafe struct FineLayoutsJob : IJob
    {
        public Padded Line;
        public Overlaid Bytes;
        public Empty Nothing;
        public MarshalledAsByte Marked;

        public void Execute()
        {
            Line.Value = sizeof(Padded) + UnsafeUtility.SizeOf<Overlaid>();
            Bytes.Whole = Bytes.Bytes[3];
            Nothing = default;
            Marked.Flag = true;
            (int first, int second) = ValueTuple.Create(Line.Value, 2).Item1 > 1 ? (1, 2) : (3, 4);
            Line.Value += first + second + Double(ValueTuple.Create(4));
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static int Double(ValueTuple<int> one) => one.Item1 * 2;
    }
}

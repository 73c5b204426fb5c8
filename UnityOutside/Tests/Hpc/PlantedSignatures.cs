#pragma warning disable CA1401, CA1823, CA2101, CA5392, CS0169, CS0649, SYSLIB1054

namespace UnityOutside.Tests.Hpc;

/// <summary>Entry methods, externs and function pointers: what may pass between compiled and other code.</summary>
internal static unsafe class PlantedSignatures
{
    internal struct Handle
    {
        public void* Ptr;
    }

    internal struct Marked
    {
        public int Value;
        public bool IsSet;
    }

    internal struct MarkedAsByte
    {
        public int Value;
        [MarshalAs(UnmanagedType.U1)] public bool IsSet;
    }

    internal struct Outer
    {
        public Marked Inner;
    }

    internal struct WithRange
    {
        public (int First, int Count) Range;
    }

    internal enum Kind : byte { First }

    private static class Native
    {
        [DllImport("own")]
        internal static extern int Count(byte* bytes, ref long length, Handle handle);

        [DllImport("own")]
        [return: MarshalAs(UnmanagedType.U1)]
        internal static extern bool IsOpen(IntPtr handle);

        [DllImport("own")]
        internal static extern float Length(float3 v);

        [DllImport("own")]
        internal static extern int Find(string name);

        [DllImport("own")]
        internal static extern void Show(bool isShown);
    }

    [Planted]
    [BurstCompile]
    internal static class FineSignatures
    {
        [BurstCompile]
        internal static bool Mark(bool isSet, Kind kind, in float3 at, Marked* byPointer, ref MarkedAsByte marked, Handle handle)
        {
            marked.IsSet = isSet;
            byPointer->Value = (int)kind;
            return at.x > 0 && handle.Ptr != null;
        }

        [BurstCompile]
        [return: MarshalAs(UnmanagedType.U1)]
        internal static bool IsPositive(int value) => value > 0 && Inner(value > 1);

        private static bool Inner([MarshalAs(UnmanagedType.U1)] bool isMore) => !isMore;
    }

    [Planted]
    [BurstCompile]
    internal static class FineExterns
    {
        [BurstCompile]
        internal static int Count(byte* bytes)
        {
            long length = 1;
            return Native.IsOpen(default) ? Native.Count(bytes, ref length, default) : 0;
        }
    }

    [Planted]
    [BurstCompile]
    internal static class FineFunctionPointer
    {
        [BurstCompile]
        internal static int Call(IntPtr function) => ((delegate* unmanaged[Cdecl]<int, int>)function)(1);
    }

    [Planted("calls a function pointer that is not unmanaged, Cdecl")]
    [BurstCompile]
    internal static class ManagedFunctionPointer
    {
        [BurstCompile]
        internal static int Call(IntPtr function) => ((delegate*<int, int>)function)(1);
    }

    [Planted("parameter letter is a char")]
    [BurstCompile]
    internal static class CharParameter
    {
        [BurstCompile]
        internal static int Code(char letter) => 1;
    }

    [Planted("parameter values is a managed array")]
    [BurstCompile]
    internal static class ArrayParameter
    {
        [BurstCompile]
        internal static int First(int[] values) => 1;
    }

    [Planted("parameter name is a string")]
    [BurstCompile]
    internal static class StringParameter
    {
        [BurstCompile]
        internal static int First(string name) => 1;
    }

    [Planted("float2 by value")]
    [BurstCompile]
    internal static class StructReturned
    {
        [BurstCompile]
        internal static float2 Of(float x) => new float2(x, x);
    }

    [Planted("Marked by reference with the bool IsSet, which is not marshalled as U1")]
    [BurstCompile]
    internal static class BoolInStruct
    {
        [BurstCompile]
        internal static int Value(ref Marked marked) => marked.Value;
    }

    [Planted("Outer by reference with the bool IsSet, which is not marshalled as U1")]
    [BurstCompile]
    internal static class BoolInNestedStruct
    {
        [BurstCompile]
        internal static int Value(in Outer outer) => outer.Inner.Value;
    }

    [Planted("System.ValueTuple`2, whose layout is Auto")]
    [BurstCompile]
    internal static class TupleByReference
    {
        [BurstCompile]
        internal static int Count(ref (int First, int Count) range) => range.Count;
    }

    [Planted("System.ValueTuple`2, whose layout is Auto")]
    [BurstCompile]
    internal static class TupleInStruct
    {
        [BurstCompile]
        internal static int Count(in WithRange range) => range.Range.Count;
    }

    [Planted("Span`1 by value")]
    [BurstCompile]
    internal static class SpanParameter
    {
        [BurstCompile]
        internal static int Length(Span<int> values) => values.Length;
    }

    [Planted("parameter isSet is marshalled as U1")]
    [BurstCompile]
    internal static class MarshalledParameter
    {
        [BurstCompile]
        internal static int Value([MarshalAs(UnmanagedType.U1)] bool isSet) => isSet ? 1 : 0;
    }

    [Planted("return value is marshalled as I8")]
    [BurstCompile]
    internal static class MarshalledReturn
    {
        [BurstCompile]
        [return: MarshalAs(UnmanagedType.I8)]
        internal static int Value(int value) => value;
    }

    [Planted("return value is marshalled as R4")]
    [BurstCompile]
    internal static class MarshalledInside
    {
        [BurstCompile]
        internal static bool Not(bool value) => Inner(value);

        [return: MarshalAs(UnmanagedType.R4)]
        private static bool Inner(bool value) => !value;
    }

    [Planted("is a method of the class InstanceMethod")]
    [BurstCompile]
    internal sealed class InstanceMethod
    {
        private readonly int m_value = 1;

        [BurstCompile]
        internal int Value() => m_value;
    }

    [Planted("a generic method cannot be called from managed code through Burst")]
    [BurstCompile]
    internal static class GenericMethod
    {
        [BurstCompile]
        internal static int Size<T>(int count) where T : unmanaged => sizeof(T) * count;
    }

    private static class FromNative
    {
        internal static readonly bool IsOpen = Native.IsOpen(default);
    }

    [Planted("calls the extern Native.IsOpen in a static constructor")]
    [BurstCompile]
    internal static class ExternInConstructor
    {
        [BurstCompile]
        internal static bool IsOpen() => FromNative.IsOpen;
    }

    [Planted("calls Native.Length with float3 by value")]
    [BurstCompile]
    internal static class ExternWithStruct
    {
        [BurstCompile]
        internal static float Length(in float3 v) => Native.Length(v);
    }

    [Planted("calls Native.Find with a string")]
    [BurstCompile]
    internal static class ExternWithString
    {
        [BurstCompile]
        internal static int Find() => Native.Find(null);
    }

    [Planted("calls Native.Show with a bool that is not marshalled as U1")]
    [BurstCompile]
    internal static class ExternWithBool
    {
        [BurstCompile]
        internal static void Show(bool isShown) => Native.Show(isShown);
    }
}

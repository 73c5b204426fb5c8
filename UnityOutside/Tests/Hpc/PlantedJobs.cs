using System.Diagnostics;

#pragma warning disable CA1822, CA1823, CA2211, CS0649, CS0169, CA2201, CA1508, IDE0059

namespace UnityOutside.Tests.Hpc;

/// <summary>Jobs that are never run: what Burst rejects, a fault each, and beside it what looks like it and is fine.</summary>
internal static class PlantedJobs
{
    internal interface IShape
    {
        float Area();
    }

    internal struct Square : IShape
    {
        public float Side;

        public float Area() => Side * Side;
    }

    internal struct BoxingSquare : IShape
    {
        public float Area()
        {
            object boxed = this;
            return boxed == null ? 0 : 1;
        }
    }

    internal class Node
    {
        public int Value;

        public virtual int Get() => Value;
    }

    internal static class Tables
    {
        internal static readonly int[] Primes = { 2, 3, 5, 7 };
        internal static readonly float2 Origin = new float2(1.0f, 2.0f);
        internal static int Counter;
    }

    internal static class NamedTables
    {
        internal static readonly int[] Sizes = { 1, 2 };
        internal static readonly string[] Names = { "one", "two" };
    }

    internal static class Helpers
    {
        internal static int Outer(int x) => Inner(x) + 1;
        private static int Inner(int x) => new object() == null ? x : 0;
        internal static float AreaOf<T>(T shape) where T : struct, IShape => shape.Area();

        [Conditional("DEBUG")]
        internal static void CheckPositive(int value)
        {
            if (value <= 0)
                throw new ArgumentException(string.Format("{0} is not positive", value));
        }

        [BurstDiscard]
        internal static void Report(int value) => Console.WriteLine($"at {value}");
    }

    [Planted]
    [BurstCompile]
    internal struct FineJob : IJobParallelFor
    {
        [ReadOnly] public NativeArray<float3> Positions;
        public NativeArray<float> Lengths;
        public float Limit;

        public void Execute(int index)
        {
            Helpers.CheckPositive(index + 1);
            Helpers.Report(index);
            float length = math.min(math.length(Positions[index]), Limit) * Tables.Primes[index & 3] + Tables.Origin.x;
            Lengths[index] = length + Helpers.AreaOf(new Square { Side = 2 }) + (float)Math.Sqrt(length);
        }
    }

    [Planted]
    [BurstCompile]
    internal unsafe struct FinePointersJob : IJob
    {
        public NativeArray<int> Counts;
        public long Bytes;

        public void Execute()
        {
            byte* scratch = stackalloc byte[64];
            scratch[3] = 1;
            fixed (long* bytes = &Bytes)
                Interlocked.Add(ref *bytes, scratch[3]);
            (int low, int high) = (Counts[0], Counts[1]);
            foreach (int count in Counts)
                high += count + low;
            if (high > 7)
                throw new InvalidOperationException("more than seven");
        }
    }

    [Planted("makes a UnityOutside.Tests.Hpc.PlantedJobs/Node")]
    [BurstCompile]
    internal struct AllocatesJob : IJob
    {
        public int Value;

        public void Execute() => Value = new Node().Value;
    }

    [Planted("makes a managed array")]
    [BurstCompile]
    internal struct ManagedArrayJob : IJob
    {
        public int Value;

        public void Execute()
        {
            var counts = new int[4];
            Value = counts[Value];
        }
    }

    [Planted("boxes")]
    [BurstCompile]
    internal struct BoxesJob : IJob
    {
        public int Value;

        public void Execute() => Value = ((IComparable)Value).CompareTo(Value);
    }

    [Planted("boxes UnityOutside.Tests.Hpc.PlantedJobs/BoxingSquare")]
    [BurstCompile]
    internal struct BoxesInGenericJob : IJob
    {
        public float Area;

        public void Execute() => Area = Helpers.AreaOf(new BoxingSquare());
    }

    [Planted("uses a string")]
    [BurstCompile]
    internal struct StringJob : IJob
    {
        public int Length;

        public void Execute() => Length = "seven".Length;
    }

    [Planted("calls System.String.get_Length, which Burst does not know")]
    [BurstCompile]
    internal struct StringCallJob : IJob
    {
        public int Length;

        public void Execute() => Length = "seven".Length;
    }

    [Planted("field Names is of the class System.Collections.Generic.List")]
    [BurstCompile]
    internal struct ClassFieldJob : IJob
    {
        public List<int> Names;

        public void Execute() { }
    }

    [Planted("field Values is a managed array")]
    [BurstCompile]
    internal struct ArrayFieldJob : IJob
    {
        public int[] Values;

        public void Execute() { }
    }

    [Planted("through an object")]
    [BurstCompile]
    internal struct VirtualCallJob : IJob
    {
        public int Value;

        public void Execute() => Value = Get(null);
        private static int Get(Node node) => node.Get();
    }

    [Planted("catches an exception")]
    [BurstCompile]
    internal struct CatchesJob : IJob
    {
        public int Value;

        public void Execute()
        {
            try
            {
                Value = 10 / Value;
            }
            catch (DivideByZeroException)
            {
                Value = 0;
            }
        }
    }

    [Planted]
    [BurstCompile]
    internal struct FinallyJob : IJob
    {
        public int Value;

        public void Execute()
        {
            try
            {
                Value++;
            }
            finally
            {
                Value--;
            }
        }
    }

    [Planted("writes the static Tables.Counter")]
    [BurstCompile]
    internal struct WritesStaticJob : IJob
    {
        public void Execute() => Tables.Counter = 1;
    }

    [Planted("reads the static Tables.Counter, which is not readonly")]
    [BurstCompile]
    internal struct ReadsStaticJob : IJob
    {
        public int Value;

        public void Execute() => Value = Tables.Counter;
    }

    [Planted("uses a string")]
    [BurstCompile]
    internal struct StaticConstructorJob : IJob
    {
        public int Value;

        public void Execute() => Value = NamedTables.Sizes[1];
    }

    [Planted("writes to a managed array")]
    [BurstCompile]
    internal struct WritesTableJob : IJob
    {
        public void Execute() => Tables.Primes[0] = 4;
    }

    [Planted("makes a delegate")]
    [BurstCompile]
    internal struct DelegateJob : IJob
    {
        public int Value;

        public void Execute()
        {
            int by = Value;
            Func<int, int> add = x => x + by;
            Value = add(1);
        }
    }

    [Planted("uses typeof")]
    [BurstCompile]
    internal struct TypeofJob : IJob
    {
        public int Value;

        public void Execute() => Value = typeof(int).GetHashCode();
    }

    [Planted("System.Console.WriteLine, which Burst does not know")]
    [BurstCompile]
    internal struct ConsoleJob : IJob
    {
        public void Execute() => Console.WriteLine(1);
    }

    [Planted("System.MathF.Sqrt, which Burst does not know")]
    [BurstCompile]
    internal struct MathFJob : IJob
    {
        public float Value;

        public void Execute() => Value = MathF.Sqrt(Value);
    }

    [Planted("Unity.Jobs.JobHandle.Complete, which is not for jobs")]
    [BurstCompile]
    internal struct CompletesJob : IJob
    {
        public JobHandle Other;

        public void Execute() => Other.Complete();
    }

    [Planted("with a managed array")]
    [BurstCompile]
    internal struct ToArrayJob : IJob
    {
        public NativeArray<int> Counts;

        public void Execute() => Counts.ToArray();
    }

    [Planted("a variable that is a char")]
    [BurstCompile]
    internal struct CharJob : IJob
    {
        public int Value;

        public void Execute()
        {
            char letter = (char)Value;
            Value = letter + 1;
            Value += letter;
        }
    }

    [Planted("a generic job needs registering")]
    [BurstCompile]
    internal struct GenericJob<T> : IJob where T : struct
    {
        public T Value;

        public void Execute() { }
    }

    [Planted("Helpers.Inner")]
    [BurstCompile]
    internal struct CallsDeepJob : IJob
    {
        public int Value;

        public void Execute() => Value = Helpers.Outer(Value);
    }

    internal struct UncompiledJob : IJob
    {
        public void Execute() { }
    }

    [Planted]
    [BurstCompile]
    internal static unsafe class FineMethods
    {
        [BurstCompile]
        internal static int Sum(int* values, int count, in float3 weight)
        {
            int sum = (int)weight.x;
            for (int i = 0; i < count; i++)
                sum += values[i];
            return sum;
        }
    }

    [Planted("float3 by value")]
    [BurstCompile]
    internal static class StructByValue
    {
        [BurstCompile]
        internal static float Length(float3 v) => math.length(v);
    }

    [Planted("its type has no [BurstCompile]")]
    internal static class UnmarkedClass
    {
        [BurstCompile]
        internal static float Twice(float v) => v * 2;
    }
}

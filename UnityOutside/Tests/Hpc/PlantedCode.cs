using Unity.Burst.CompilerServices;

#pragma warning disable CA1814, CA1823, CA1508, CA2101, CS0649, IDE0059, IDE0150

namespace Unity.Burst.CompilerServices
{
    /// <summary>Burst has it behind a define, so the stand-in has not.</summary>
    internal static class Loop
    {
        internal static void ExpectVectorized() { }
        internal static void ExpectNotVectorized() { }
    }
}

namespace UnityOutside.Tests.Hpc
{
    /// <summary>Jobs that are never run: expressions and calls that Burst takes, and beside them those that it does
    /// not.</summary>
    internal static class PlantedCode
    {
        internal interface IValue
        {
            int Value { get; set; }
        }

        internal struct StructValue : IValue
        {
            public int Value { get; set; }
        }

        internal sealed class ClassValue : IValue
        {
            public int Value { get; set; }
        }

        internal interface ISource<TKey>
        {
            int Read<T>(TKey key, T value) where T : IValue;
        }

        internal struct Source : ISource<int>
        {
            public int Read<T>(int key, T value) where T : IValue => value.Value + key;
        }

        [Flags]
        internal enum Parts { First = 1 }

        internal static class Tables
        {
            internal static readonly int[] None = null;
            internal static readonly int[][] Rows = { new[] { 1, 2 }, new[] { 3, 4 } };
        }

        internal static class Grids
        {
            internal static readonly int[,] Grid = { { 1, 2 }, { 3, 4 } };
        }

        internal static class Helpers
        {
            internal static int MakeAndRead<T>(int value) where T : IValue, new() => new T { Value = value }.Value;

            internal static int ReadFrom<TSource, TKey>(TSource source, TKey key) where TSource : struct, ISource<TKey> =>
                source.Read(key, new StructValue());

            internal static bool IsClass<T>() => default(T) is null;
            internal static bool IsInt<T>() => typeof(T) == typeof(int);

            [BurstDiscard]
            internal static int Managed() => Environment.ProcessId;

            [MethodImpl(MethodImplOptions.NoOptimization)]
            internal static int SumSlowly(int count)
            {
                int sum = 0;
                for (int i = 0; i < count; i++)
                {
                    Loop.ExpectVectorized();
                    sum += i;
                }
                return sum;
            }
        }

        [Planted]
        [BurstCompile]
        internal struct FineCodeJob : IJob
        {
            public Guid Id;
            public int Value;

            public void Execute()
            {
                ClassValue nothing = null;
                ClassValue alsoNothing = nothing;
                Value = Helpers.MakeAndRead<StructValue>(2) + Helpers.ReadFrom(new Source(), 3);
                Value += Helpers.IsClass<int>() || Tables.None == null ? 1 : Tables.Rows[1][Value];
                if (Id == new Guid(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11) || !Id.Equals(default))
                    Value = (int)Math.Round(2.5) + (int)Math.Round(2.5, MidpointRounding.AwayFromZero);
                for (int i = 0; i < 8; i++)
                {
                    Loop.ExpectVectorized();
                    Value += i;
                }
            }
        }

        [Planted("makes a UnityOutside.Tests.Hpc.PlantedCode/ClassValue")]
        [BurstCompile]
        internal struct NewOfClassJob : IJob
        {
            public int Value;

            public void Execute() => Value = Helpers.MakeAndRead<ClassValue>(2);
        }

        [Planted("boxes UnityOutside.Tests.Hpc.PlantedCode/ClassValue")]
        [BurstCompile]
        internal struct ClassIsNullJob : IJob
        {
            public int Value;

            public void Execute() => Value = Helpers.IsClass<ClassValue>() ? 1 : 0;
        }

        [Planted("System.Enum.HasFlag, which Burst does not know")]
        [BurstCompile]
        internal struct HasFlagJob : IJob
        {
            public Parts Parts;
            public int Value;

            public void Execute() => Value = Parts.HasFlag(Parts.First) ? 1 : 0;
        }

        [Planted("System.Guid.NewGuid, which Burst does not know")]
        [BurstCompile]
        internal struct NewGuidJob : IJob
        {
            public Guid Id;

            public void Execute() => Id = Guid.NewGuid();
        }

        [Planted("calls System.Guid..ctor with a string")]
        [BurstCompile]
        internal struct GuidOfTextJob : IJob
        {
            public Guid Id;

            public void Execute() => Id = new Guid("a");
        }

        [Planted("uses the value of Helpers.Managed, which is [BurstDiscard]")]
        [BurstCompile]
        internal struct DiscardedValueJob : IJob
        {
            public int Value;

            public void Execute() => Value = Helpers.Managed();
        }

        [Planted("uses typeof")]
        [BurstCompile]
        internal struct CompareTypesJob : IJob
        {
            public int Value;

            public void Execute() => Value = Helpers.IsInt<int>() ? 1 : 0;
        }

        [Planted("System.Math.IEEERemainder, which Burst does not know")]
        [BurstCompile]
        internal struct RemainderJob : IJob
        {
            public double Value;

            public void Execute() => Value = Math.IEEERemainder(Value, 3);
        }

        [Planted("System.Math.Round, which Burst does not know")]
        [BurstCompile]
        internal struct RoundToDigitsJob : IJob
        {
            public double Value;

            public void Execute() => Value = Math.Round(Value, 2);
        }

        [Planted("calls System.Math.Abs with a decimal")]
        [BurstCompile]
        internal struct DecimalJob : IJob
        {
            public int Value;

            public void Execute() => Value = Math.Abs(default(decimal)) == default ? 1 : 0;
        }

        [Planted("reads a table of a table by an index that is not constant")]
        [BurstCompile]
        internal struct NestedTableJob : IJob
        {
            public int Value;

            public void Execute() => Value = Tables.Rows[Value][0];
        }

        [Planted("reads the static Grids.Grid, a managed array")]
        [BurstCompile]
        internal struct GridTableJob : IJob
        {
            public int Value;

            public void Execute() => Value = Grids.Grid[1, 1];
        }

        [Planted("calls Loop.ExpectVectorized outside of a loop")]
        [BurstCompile]
        internal struct LoopOutsideJob : IJob
        {
            public int Value;

            public void Execute()
            {
                Loop.ExpectVectorized();
                for (int i = 0; i < 8; i++)
                    Value += i;
            }
        }

        [Planted("calls Loop.ExpectNotVectorized outside of a loop")]
        [BurstCompile]
        internal struct LoopAfterJob : IJob
        {
            public int Value;

            public void Execute()
            {
                for (int i = 0; i < 8; i++)
                    Value += i;
                Loop.ExpectNotVectorized();
            }
        }

        [Planted("expects vectors of SumSlowly, which is not optimised")]
        [BurstCompile]
        internal struct LoopNotOptimisedJob : IJob
        {
            public int Value;

            public void Execute() => Value = Helpers.SumSlowly(Value);
        }
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.HostTests.StandIns
{
    public sealed unsafe class NativeContainerTests
    {
        [SetUp]
        public void Workers() => JobsUtility.JobWorkerCount = 3;

        [TearDown]
        public void DefaultWorkers() => JobsUtility.ResetJobWorkerCount();

        [Test]
        public void Array_New_IsClearedAndCopies()
        {
            using var array = new NativeArray<long>(5, Allocator.Persistent);
            Assert.That(array.ToArray(), Is.All.EqualTo(0));
            array.CopyFrom(new long[] { 1, 2, 3, 4, 5 });
            using var copy = new NativeArray<long>(array, Allocator.Persistent);
            NativeArray<long>.Copy(array, 1, copy, 0, 3);
            Assert.That(copy.ToArray(), Is.EqualTo(new long[] { 2, 3, 4, 4, 5 }));
            var managed = new long[5];
            copy.CopyTo(managed);
            Assert.That(managed, Is.EqualTo(copy.ToArray()));
            Assert.That(array == copy, Is.False);
            Assert.That(array.GetSubArray(0, 5) == array, Is.True);
        }

        [Test]
        public void Array_OverlappingCopyOfItself_MovesRightly()
        {
            using var array = new NativeArray<int>(new[] { 1, 2, 3, 4, 5 }, Allocator.Persistent);
            NativeArray<int>.Copy(array, 0, array, 1, 4);
            Assert.That(array.ToArray(), Is.EqualTo(new[] { 1, 1, 2, 3, 4 }));
        }

        [Test]
        public void Array_ViewsOfIt_ShareItsMemory()
        {
            using var array = new NativeArray<int>(new[] { 0x01020304, 0x05060708 }, Allocator.Persistent);
            Assert.That(array.Reinterpret<byte>(4).ToArray(), Is.EqualTo(new byte[] { 4, 3, 2, 1, 8, 7, 6, 5 }));
            Assert.That(array.Reinterpret<uint>()[1], Is.EqualTo(0x05060708u));
            Assert.That(array.ReinterpretLoad<long>(0), Is.EqualTo(0x0506070801020304));
            Assert.That(array.AsReadOnly().Reinterpret<float>().Length, Is.EqualTo(2));
            Assert.That(array.AsReadOnlySpan()[0], Is.EqualTo(array.GetSubArray(0, 1)[0]));
            array.AsSpan()[1] = 9;
            Assert.That(array[1], Is.EqualTo(9));
            Assert.That(array.Sum(), Is.EqualTo(0x01020304 + 9));
        }

        [Test]
        public void Array_BadArguments_Throw()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            Assert.That(() => new NativeArray<int>(-1, Allocator.Persistent), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => new NativeArray<int>(1, Allocator.None), Throws.ArgumentException);
            Assert.That(() => new NativeArray<ValueTuple<string>>(1, Allocator.Persistent), Throws.InvalidOperationException);
            using var array = new NativeArray<int>(3, Allocator.Persistent);
            Assert.That(() => array.GetSubArray(2, 2), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => array.GetSubArray(-1, 2), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => array.Reinterpret<long>(), Throws.InvalidOperationException);
            Assert.That(() => array.Reinterpret<long>(4), Throws.InvalidOperationException);
            Assert.That(() => array.CopyFrom(new int[2]), Throws.ArgumentException);
            Assert.That(() => NativeArray<int>.Copy(array, 1, array, 0, 3), Throws.ArgumentException);
#endif
            Assert.That(() => new NativeArray<int>((int[])null, Allocator.Persistent), Throws.TypeOf<ArgumentNullException>());
        }

        [Test]
        public void Array_OfConvertedMemory_IsNotFreed()
        {
            int* memory = stackalloc int[] { 1, 2 };
            NativeArray<int> array = CollectionHelper.ConvertExistingDataToNativeArray<int>(memory, 2, Allocator.None, true);
            array[0] += array[1];
            array.Dispose();
            Assert.That(memory[0], Is.EqualTo(3));
        }

        [Test]
        public void List_AgainstAModel_GivesTheSame()
        {
            var model = new List<int>();
            using var list = new NativeList<int>(Allocator.Persistent);
            var random = new Random(7);
            for (int step = 0; step < 5000; step++)
            {
                int at = model.Count == 0 ? 0 : random.Next(model.Count);
                switch (random.Next(8))
                {
                    case 0 when model.Count > 0:
                        model.RemoveAt(at);
                        list.RemoveAt(at);
                        break;
                    case 1 when model.Count > 0:
                        model[at] = model[model.Count - 1];
                        model.RemoveAt(model.Count - 1);
                        list.RemoveAtSwapBack(at);
                        break;
                    case 2 when model.Count > at + 3:
                        model.RemoveRange(at, 3);
                        list.RemoveRange(at, 3);
                        break;
                    case 3:
                        model.InsertRange(at, new[] { step, step });
                        list.InsertRange(at, 2);
                        list.AsArray().GetSubArray(at, 2).CopyFrom(new[] { step, step });
                        break;
                    case 4:
                        model.AddRange(Enumerable.Repeat(step, 3));
                        list.AddReplicate(step, 3);
                        break;
                    case 5 when random.Next(100) == 0:
                        model.Clear();
                        list.Clear();
                        break;
                    default:
                        model.Add(step);
                        list.Add(step);
                        break;
                }
                Assert.That(list.Length, Is.EqualTo(model.Count));
            }
            Assert.That(list.AsArray().ToArray(), Is.EqualTo(model));
        }

        [Test]
        public void List_ResizeAndCapacity_KeepWhatWasThere()
        {
            using var list = new NativeList<int>(2, Allocator.Persistent);
            list.Add(1);
            list.Resize(100, NativeArrayOptions.ClearMemory);
            Assert.That(list.AsArray().ToArray(), Is.EqualTo(new[] { 1 }.Concat(new int[99])));
            list.ResizeUninitialized(1);
            Assert.That(list.Capacity, Is.GreaterThanOrEqualTo(100));
            list.TrimExcess();
            Assert.That((list.Capacity, list[0]), Is.EqualTo((1, 1)));
            list.SetCapacity(33);
            Assert.That(list.Capacity, Is.EqualTo(64));
            using NativeArray<int> copy = list.ToArray(Allocator.Persistent);
            list.AddRange(copy);
            list.ElementAt(1)++;
            Assert.That(list.AsArray().ToArray(), Is.EqualTo(new[] { 1, 2 }));
            Assert.That((list.IsEmpty, list.IsCreated), Is.EqualTo((false, true)));
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            Assert.That(() => list.SetCapacity(1), Throws.TypeOf<ArgumentOutOfRangeException>());
            list.TrimExcess();
            Assert.That(() => list.AddNoResize(1), Throws.InvalidOperationException);
#endif
        }

        struct AppendJob : IJobFor
        {
            public NativeList<int>.ParallelWriter List;
            public NativeQueue<int>.ParallelWriter Queue;
            public NativeParallelHashMap<int, int>.ParallelWriter Map;

            public void Execute(int index)
            {
                List.AddNoResize(index);
                Queue.Enqueue(index);
                // Every key from several threads: one wins.
                Map.TryAdd(index / 4, index);
            }
        }

        [Test]
        public void ParallelWriters_FromManyThreads_LoseNothing()
        {
            const int count = 20000;
            using var list = new NativeList<int>(count, Allocator.Persistent);
            using var queue = new NativeQueue<int>(Allocator.Persistent);
            using var map = new NativeParallelHashMap<int, int>(count, Allocator.Persistent);
            new AppendJob { List = list.AsParallelWriter(), Queue = queue.AsParallelWriter(), Map = map.AsParallelWriter() }
                .ScheduleParallel(count, 1, default).Complete();
            Assert.That(list.AsArray().ToArray().OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, count)));
            using NativeArray<int> queued = queue.ToArray(Allocator.Persistent);
            Assert.That(queued.ToArray().OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, count)));
            Assert.That(map.Count(), Is.EqualTo(count / 4));
            foreach (KeyValue<int, int> pair in map)
                Assert.That(pair.Value / 4, Is.EqualTo(pair.Key));
        }

        [Test]
        public void Reference_ValueAndCopies_Agree()
        {
            using var a = new NativeReference<long>(5, Allocator.Persistent);
            using var b = new NativeReference<long>(Allocator.Persistent);
            Assert.That(b.Value, Is.Zero);
            b.CopyFrom(a);
            Assert.That(b == a, Is.True);
            Assert.That(b.AsReadOnly().Value, Is.EqualTo(5));
        }

        [Test]
        public void Queue_AgainstAModel_GivesTheSame()
        {
            var model = new Queue<int>();
            using var queue = new NativeQueue<int>(Allocator.Persistent);
            var random = new Random(3);
            for (int step = 0; step < 5000; step++)
            {
                if (random.Next(5) < 3)
                {
                    model.Enqueue(step);
                    queue.Enqueue(step);
                }
                else
                {
                    bool any = queue.TryDequeue(out int item);
                    Assert.That(any, Is.EqualTo(model.Count > 0));
                    if (any)
                        Assert.That(item, Is.EqualTo(model.Dequeue()));
                }
                Assert.That(queue.Count, Is.EqualTo(model.Count));
            }
            Assert.That(queue.AsReadOnly(), Is.EqualTo(model));
            Assert.That(queue.Peek(), Is.EqualTo(model.Peek()));
            queue.Clear();
            Assert.That(queue.IsEmpty(), Is.True);
            Assert.That(() => queue.Dequeue(), Throws.InvalidOperationException);
        }

        [Test]
        public void HashMaps_AgainstAModel_GiveTheSame()
        {
            var model = new Dictionary<int, int>();
            var map = new NativeHashMap<int, int>(1, Allocator.Persistent);
            using var parallel = new NativeParallelHashMap<int, int>(1, Allocator.Persistent);
            using var set = new NativeHashSet<int>(1, Allocator.Persistent);
            var random = new Random(5);
            for (int step = 0; step < 20000; step++)
            {
                int key = random.Next(600) * 4096;
                if (random.Next(3) > 0)
                {
                    bool added = model.TryAdd(key, step);
                    Assert.That(map.TryAdd(key, step), Is.EqualTo(added));
                    Assert.That(parallel.TryAdd(key, step), Is.EqualTo(added));
                    Assert.That(set.Add(key), Is.EqualTo(added));
                }
                else
                {
                    bool removed = model.Remove(key);
                    Assert.That(map.Remove(key), Is.EqualTo(removed));
                    Assert.That(parallel.Remove(key), Is.EqualTo(removed));
                    Assert.That(set.Remove(key), Is.EqualTo(removed));
                }
            }
            Assert.That((map.Count, parallel.Count(), set.Count), Is.EqualTo((model.Count, model.Count, model.Count)));
            Assert.That(map.ToDictionary(p => p.Key, p => p.Value), Is.EquivalentTo(model));
            Assert.That(parallel.ToDictionary(p => p.Key, p => p.Value), Is.EquivalentTo(model));
            Assert.That(set, Is.EquivalentTo(model.Keys));
            using NativeKeyValueArrays<int, int> arrays = map.GetKeyValueArrays(Allocator.Persistent);
            for (int i = 0; i < arrays.Length; i++)
                Assert.That(arrays.Values[i], Is.EqualTo(model[arrays.Keys[i]]));
            Assert.That(map.TryGetValue(-1, out int missing), Is.False);
            Assert.That(missing, Is.Zero);
            Assert.That(() => map[-1], Throws.ArgumentException);
            int present = model.Keys.First();
            Assert.That(() => map.Add(present, 0), Throws.ArgumentException);
            map[present] = 77;
            Assert.That(map[present], Is.EqualTo(77));
            map.TrimExcess();
            Assert.That(map.Count, Is.EqualTo(model.Count));
            map.Clear();
            Assert.That(map.IsEmpty, Is.True);
            map.Dispose();
        }

        struct Descending : IComparer<int>
        {
            public int Compare(int x, int y) => y.CompareTo(x);
        }

        [TestCase(0, 1)]
        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(17, 3)]
        [TestCase(1000, 1000000)]
        [TestCase(1000, 3)]
        [TestCase(5000, 1)]
        public void Sort_AnyLengthAndValues_AgreesWithTheFramework(int length, int range)
        {
            var random = new Random(length + range);
            for (int round = 0; round < 5; round++)
            {
                int[] expected = Enumerable.Range(0, length).Select(i => round == 0 ? i : round == 1 ? length - i
                    : random.Next(range)).ToArray();
                using var array = new NativeArray<int>(expected, Allocator.Persistent);
                using var list = new NativeList<int>(Allocator.Persistent);
                list.AddRange(array);
                Array.Sort(expected);
                array.Sort();
                list.Sort(new Descending());
                Assert.That(array.ToArray(), Is.EqualTo(expected));
                Assert.That(list.AsArray().ToArray(), Is.EqualTo(expected.Reverse()));
                if (length > 0)
                    Assert.That(array[array.BinarySearch(expected[length / 2])], Is.EqualTo(expected[length / 2]));
                Assert.That(array.BinarySearch(int.MaxValue), Is.EqualTo(~length));
            }
        }

        [Test]
        public void Dispose_ByAJob_FreesEveryKindOfContainer()
        {
            int before = global::StandIns.Memory.AllocationLedger.Live();
            JobHandle all = new NativeArray<int>(1, Allocator.Persistent).Dispose(default(JobHandle));
            all = new NativeList<int>(1, Allocator.Persistent).Dispose(all);
            all = new NativeReference<int>(Allocator.Persistent).Dispose(all);
            all = new NativeQueue<int>(Allocator.Persistent).Dispose(all);
            all = new NativeHashMap<int, int>(1, Allocator.Persistent).Dispose(all);
            all = new NativeParallelHashMap<int, int>(1, Allocator.Persistent).Dispose(all);
            all = new NativeHashSet<int>(1, Allocator.Persistent).Dispose(all);
            all = new UnsafeList<int>(1, Allocator.Persistent).Dispose(all);
            all.Complete();
            Assert.That(global::StandIns.Memory.AllocationLedger.Live(), Is.EqualTo(before));
        }

        struct TempInAJob : IJob
        {
            public NativeReference<int> Sum;

            public void Execute()
            {
                var scratch = new NativeArray<int>(100, Allocator.Temp);
                var list = new NativeList<int>(Allocator.Temp);
                for (int i = 0; i < 100; i++)
                {
                    scratch[i] = i;
                    list.Add(scratch[i]);
                }
                foreach (int value in list)
                    Sum.Value += value;
            }
        }

        [Test]
        public void TempMemory_InsideAJob_NeedsNoDispose()
        {
            using var sum = new NativeReference<int>(Allocator.Persistent);
            new TempInAJob { Sum = sum }.Schedule().Complete();
            Assert.That(sum.Value, Is.EqualTo(4950));
        }

        [Test]
        public void UnsafeUtility_MemoryOperations_DoWhatTheySay()
        {
            byte* a = (byte*)UnsafeUtility.Malloc(64, 64, Allocator.Persistent);
            byte* b = (byte*)UnsafeUtility.Malloc(64, 16, Allocator.Persistent);
            Assert.That((long)a % 64, Is.Zero);
            for (int i = 0; i < 64; i++)
                a[i] = (byte)i;
            UnsafeUtility.MemCpy(b, a, 64);
            Assert.That(UnsafeUtility.MemCmp(a, b, 64), Is.Zero);
            UnsafeUtility.MemMove(b + 1, b, 63);
            Assert.That((b[0], b[1], b[63]), Is.EqualTo((0, 0, 62)));
            UnsafeUtility.MemSet(b, 7, 64);
            UnsafeUtility.MemCpyStride(b, 8, a, 16, 2, 4);
            Assert.That((b[0], b[1], b[2], b[8], b[24], b[25]), Is.EqualTo((0, 1, 7, 16, 48, 49)));
            UnsafeUtility.MemCpyReplicate(b, a + 5, 1, 3);
            Assert.That((b[0], b[1], b[2]), Is.EqualTo((5, 5, 5)));
            UnsafeUtility.MemClear(b, 64);
            Assert.That(UnsafeUtility.MemCmp(a, b, 64), Is.GreaterThan(0));
            UnsafeUtility.WriteArrayElement(b, 3, 0x11223344);
            Assert.That(UnsafeUtility.ReadArrayElement<short>(b, 6), Is.EqualTo(0x3344));
            Assert.That(UnsafeUtility.AlignOf<double>(), Is.EqualTo(8));
            Assert.That(UnsafeUtility.SizeOf<decimal>(), Is.EqualTo(16));
            UnsafeUtility.Free(a, Allocator.Persistent);
            UnsafeUtility.Free(b, Allocator.Persistent);
        }
    }
}

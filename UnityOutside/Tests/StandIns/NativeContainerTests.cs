using Random = System.Random;

namespace UnityOutside.Tests.StandIns;

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
    public void Array_Views_ShareItsMemory()
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
        NativeArray<int> array = NativeArrayUnsafeUtility.ConvertExistingDataToNativeArray<int>(memory, 2, Allocator.None);
        NativeArrayUnsafeUtility.SetAtomicSafetyHandle(ref array, AtomicSafetyHandle.GetTempMemoryHandle());
        array[0] += array[1];
        array.Dispose();
        Assert.That(memory[0], Is.EqualTo(3));
    }

    [Test]
    public void List_RandomOperations_MatchAModel()
    {
        var model = new List<int>();
        using var list = new NativeList<int>(Allocator.Persistent);
        var random = new Random(7);
        int* three = stackalloc int[3];
        for (int step = 0; step < 5000; step++)
        {
            three[0] = three[1] = three[2] = step;
            int at = model.Count == 0 ? 0 : random.Next(model.Count);
            switch (random.Next(6))
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
                case 2:
                    model.AddRange(Enumerable.Repeat(step, 3));
                    list.AddRange(three, 3);
                    break;
                case 3 when random.Next(100) == 0:
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
    public void List_ResizeAndCapacity_KeepTheElements()
    {
        using var list = new NativeList<int>(2, Allocator.Persistent);
        list.Add(1);
        list.Resize(100, NativeArrayOptions.ClearMemory);
        Assert.That(list.AsArray().ToArray(), Is.EqualTo(new[] { 1 }.Concat(new int[99])));
        list.ResizeUninitialized(1);
        Assert.That(list.Capacity, Is.EqualTo(128));
        list.SetCapacity(33);
        Assert.That((list.Capacity, list[0]), Is.EqualTo((64, 1)));
        list.SetCapacity(1);
        Assert.That((list.Capacity, list[0]), Is.EqualTo((16, 1)));
        list.AddRange(list.AsArray());
        list.ElementAt(1)++;
        Assert.That(list.AsArray().ToArray(), Is.EqualTo(new[] { 1, 2 }));
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        Assert.That(() => list.SetCapacity(1), Throws.TypeOf<ArgumentOutOfRangeException>());
#endif
    }

    [Test]
    public void Dispose_ByAJob_FreesTheArrayAfterItsDependencies()
    {
        int before = global::StandIns.Memory.AllocationLedger.Live();
        var array = new NativeArray<int>(1, Allocator.Persistent);
        NativeArray<int> copy = array;
        JobHandle disposed = array.Dispose(default(JobHandle));
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        Assert.That(() => copy[0], Throws.TypeOf<ObjectDisposedException>(), "though nothing is freed yet");
#endif
        disposed = new NativeArray<int>(1, Allocator.TempJob).Dispose(disposed);
        disposed.Complete();
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
    public void UnsafeUtility_MemoryOperations_Work()
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
        Assert.That((b[0], b[63]), Is.EqualTo((7, 7)));
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

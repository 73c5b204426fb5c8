using StandIns.Io;
using StandIns.Scheduling;
using Random = System.Random;

namespace UnityOutside.Tests.StandIns;

public sealed unsafe class AsyncReadTests
{
    const int FileBytes = 100_000;

    string m_path;
    byte[] m_bytes;
    NativeArray<byte> m_buffer;
    NativeArray<ReadCommand> m_commands;

    [SetUp]
    public void MakeFile()
    {
        m_path = Path.Combine(Path.GetTempPath(), $"fastpoints-read-{Guid.NewGuid():N}.bin");
        m_bytes = new byte[FileBytes];
        new Random(1).NextBytes(m_bytes);
        File.WriteAllBytes(m_path, m_bytes);
        m_buffer = new NativeArray<byte>(FileBytes + 1000, Allocator.Persistent);
        m_commands = new NativeArray<ReadCommand>(3, Allocator.Persistent);
    }

    [TearDown]
    public void DeleteFile()
    {
        IoThreads.Pause(false);
        m_buffer.Dispose();
        m_commands.Dispose();
        File.Delete(m_path);
    }

    ReadCommand Command(long offset, long size, int at) =>
        new ReadCommand { Offset = offset, Size = size, Buffer = (byte*)m_buffer.GetUnsafePtr() + at };

    ReadHandle Read(string path, params ReadCommand[] commands)
    {
        NativeArray<ReadCommand>.Copy(commands, m_commands, commands.Length);
        return AsyncReadManager.Read(path, (ReadCommand*)m_commands.GetUnsafePtr(), (uint)commands.Length);
    }

    [Test]
    public void Read_SeveralCommands_FillsTheirBuffers()
    {
        ReadHandle read = Read(m_path, Command(50, 200, 0), Command(0, 10, 300), Command(99_999, 1, 400));
        read.JobHandle.Complete();
        Assert.That(read.Status, Is.EqualTo(ReadStatus.Complete));
        Assert.That((read.ReadCount, read.GetBytesRead(), read.GetBytesRead(1)), Is.EqualTo((3L, 211L, 10L)));
        Assert.That(read.GetBytesReadArray()[0], Is.EqualTo(200));
        read.Dispose();
        Assert.That(m_buffer.GetSubArray(0, 200).ToArray(), Is.EqualTo(m_bytes.Skip(50).Take(200)));
        Assert.That(m_buffer.GetSubArray(300, 10).ToArray(), Is.EqualTo(m_bytes.Take(10)));
        Assert.That(m_buffer[400], Is.EqualTo(m_bytes[99_999]));
    }

    [Test]
    public void Read_BegunAndDisposedAgain_MakesNoGarbage()
    {
        const int Reads = 8;
        var commands = stackalloc ReadCommand[1];
        commands[0] = Command(0, 100, 0);
        var reads = new ReadHandle[Reads];
        long garbage = 0;
        for (int turn = 0; turn < 4; turn++)
        {
            // Nobody reads before all have begun: then each turn needs as many objects.
            IoThreads.Pause(true);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < Reads; i++)
                reads[i] = AsyncReadManager.Read(m_path, commands, 1);
            garbage = GC.GetAllocatedBytesForCurrentThread() - before;
            IoThreads.Pause(false);
            foreach (var read in reads)
                read.JobHandle.Complete();
            before = GC.GetAllocatedBytesForCurrentThread();
            foreach (var read in reads)
                read.Dispose();
            garbage += GC.GetAllocatedBytesForCurrentThread() - before;
        }
        Assert.That(garbage, Is.Zero);
    }

    [Test]
    public void File_OpenedReadAndClosedAgain_MakesNoGarbage()
    {
        const int Files = 8;
        var commands = stackalloc ReadCommand[1];
        commands[0] = Command(0, 100, 0);
        var array = new ReadCommandArray { ReadCommands = commands, CommandCount = 1 };
        var files = new FileHandle[Files];
        var reads = new ReadHandle[Files];
        JobHandle[] closed = new JobHandle[Files], others = new JobHandle[Files];
        Action nothing = () => { };
        long garbage = 0, ofChecks = 0;
        for (int turn = 0; turn < 4; turn++)
        {
            IoThreads.Pause(true);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < Files; i++)
            {
                files[i] = AsyncReadManager.OpenFileAsync(m_path);
                reads[i] = AsyncReadManager.Read(files[i], array);
            }
            garbage = GC.GetAllocatedBytesForCurrentThread() - before;
            IoThreads.Pause(false);
            foreach (var read in reads)
            {
                read.JobHandle.Complete();
                Assert.That((read.Status, m_buffer[99]), Is.EqualTo((ReadStatus.Complete, m_bytes[99])));
                read.Dispose();
            }
            foreach (var file in files)
                file.JobHandle.Complete();
            before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < Files; i++)
                closed[i] = files[i].Close();
            garbage += GC.GetAllocatedBytesForCurrentThread() - before;
            // The safety checks of the test build remember each job; nothing else may allocate.
            before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < Files; i++)
                others[i] = JobScheduler.CallAfter(default, "nothing", nothing);
            ofChecks = GC.GetAllocatedBytesForCurrentThread() - before;
            foreach (var handle in closed.Concat(others))
                handle.Complete();
            Assert.That(files.Any(f => f.IsValid()), Is.False);
        }
        Assert.That(garbage, Is.EqualTo(ofChecks));
    }

    [Test]
    public void File_WithinThePreparedCount_MakesNoGarbage()
    {
        const int Files = 300;
        var files = new FileHandle[Files];
        var reads = new ReadHandle[Files];
        m_commands[0] = Command(0, 100, 0);
        var array = new ReadCommandArray { ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(), CommandCount = 1 };
        // The handles' own tables, and what one of each needs once.
        long least = long.MaxValue;
        for (int turn = 0; turn < 4 && least > 0; turn++)
        {
            // Tests beside this one may take some, in one turn.
            IoThreads.Prepare(turn == 0 ? 1 : Files + 16);
            int count = turn == 0 ? 1 : Files;
            IoThreads.Pause(true);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < count; i++)
                files[i] = AsyncReadManager.OpenFileAsync(m_path);
            for (int i = 0; i < count; i++)
                reads[i] = AsyncReadManager.Read(files[i], array);
            long garbage = GC.GetAllocatedBytesForCurrentThread() - before;
            IoThreads.Pause(false);
            for (int i = 0; i < count; i++)
            {
                reads[i].JobHandle.Complete();
                reads[i].Dispose();
                files[i].Close().Complete();
            }
            if (turn > 0)
                least = Math.Min(least, garbage);
        }
        Assert.That(least, Is.Zero);
    }

    [Test]
    public void Read_BeyondTheEnd_IsTruncated()
    {
        ReadHandle read = Read(m_path, Command(FileBytes - 10, 100, 0));
        read.JobHandle.Complete();
        Assert.That(read.Status, Is.EqualTo(ReadStatus.Truncated));
        Assert.That(read.GetBytesRead(), Is.EqualTo(10));
        read.Dispose();
    }

    [Test]
    public void Read_MissingFile_Fails()
    {
        ReadHandle read = Read(m_path + ".missing", Command(0, 10, 0));
        read.JobHandle.Complete();
        Assert.That(read.Status, Is.EqualTo(ReadStatus.Failed));
        Assert.That(read.GetBytesRead(), Is.Zero);
        read.Dispose();
        FileHandle file = AsyncReadManager.OpenFileAsync(Path.GetTempPath());
        file.JobHandle.Complete();
        Assert.That(file.Status, Is.EqualTo(FileStatus.OpenFailed));
        file.Close().Complete();
    }

    [Test]
    public void OpenFile_WithoutAName_Throws() =>
        Assert.That(() => AsyncReadManager.OpenFileAsync(""), Throws.InvalidOperationException);

    [Test]
    public void Read_InProgress_ThrowsOnUse()
    {
        IoThreads.Pause(true);
        ReadHandle read = Read(m_path, Command(0, 10, 0));
        Assert.That(read.Status, Is.EqualTo(ReadStatus.InProgress));
        Assert.That(read.JobHandle.IsCompleted, Is.False);
        Assert.That(() => read.Dispose(),
            Throws.InvalidOperationException.With.Message.Contains("until the read operation completes"));
        Assert.That(() => read.GetBytesRead(), Throws.InvalidOperationException);
        IoThreads.Pause(false);
        read.JobHandle.Complete();
        read.Dispose();
        Assert.That(read.IsValid(), Is.False);
        Assert.That(() => read.Dispose(), Throws.InvalidOperationException);
        Assert.That(() => read.Status, Throws.InvalidOperationException);
    }

    [Test]
    public void Handle_NeverScheduled_HasNoStatus()
    {
        Assert.That(default(ReadHandle).IsValid(), Is.False);
        Assert.That(() => default(ReadHandle).Status, Throws.InvalidOperationException);
        Assert.That(default(ReadStatus), Is.EqualTo(ReadStatus.Complete));
    }

    [Test]
    public void Read_FileNotOpenYet_WaitsUnderAStatusWithoutAName()
    {
        IoThreads.Pause(true);
        FileHandle file = AsyncReadManager.OpenFileAsync(m_path);
        m_commands[0] = Command(0, 10, 0);
        var array = new ReadCommandArray { ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(), CommandCount = 1 };
        ReadHandle early = AsyncReadManager.Read(file, array);
        Assert.That(((int)early.Status, early.JobHandle.IsCompleted), Is.EqualTo((3, false)));
        Assert.That(() => early.Dispose(), Throws.InvalidOperationException);
        IoThreads.Pause(false);
        early.JobHandle.Complete();
        Assert.That(early.Status, Is.EqualTo(ReadStatus.Complete));
        early.Dispose();
        IoThreads.Pause(true);
        ReadHandle late = AsyncReadManager.Read(file, array);
        Assert.That(late.Status, Is.EqualTo(ReadStatus.InProgress));
        IoThreads.Pause(false);
        late.JobHandle.Complete();
        late.Dispose();
        file.Close().Complete();
    }

    /// <summary>As on macOS and Linux; on Windows nothing stays open.</summary>
    [Test]
    public void Read_FileReplacedUnderItsName_ReadsTheOriginal()
    {
        byte First(string path)
        {
            ReadHandle read = Read(path, Command(0, 1, 0));
            read.JobHandle.Complete();
            read.Dispose();
            return m_buffer[0];
        }

        First(m_path);
        File.Delete(m_path);
        File.WriteAllBytes(m_path, new[] { (byte)(m_bytes[0] + 1) });
        int kept = OperatingSystem.IsWindows() ? 1 : 0;
        Assert.That(First(m_path), Is.EqualTo((byte)(m_bytes[0] + kept)));
        for (int i = 0; i < 10; i++)
        {
            string other = $"{m_path}.{i}";
            File.WriteAllBytes(other, m_bytes);
            First(other);
            File.Delete(other);
        }
        Assert.That(First(m_path), Is.EqualTo((byte)(m_bytes[0] + 1)), "ten others were read since");
    }

    [Test]
    public void Read_CancelledBeforeItBegan_ReadsNothing()
    {
        IoThreads.Pause(true);
        ReadHandle read = Read(m_path, Command(0, 10, 0));
        read.Cancel();
        IoThreads.Pause(false);
        read.JobHandle.Complete();
        Assert.That(read.Status, Is.EqualTo(ReadStatus.Canceled));
        Assert.That(read.GetBytesRead(), Is.Zero);
        read.Dispose();
    }

    struct SumBytesJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public NativeReference<long> Sum;

        public void Execute()
        {
            foreach (byte value in Bytes)
                Sum.Value += value;
        }
    }

    struct WriteCommandJob : IJob
    {
        public NativeArray<ReadCommand> Commands;
        public long Offset;
        public long Size;

        public void Execute()
        {
            ReadCommand command = Commands[0];
            command.Offset = Offset;
            command.Size = Size;
            Commands[0] = command;
        }
    }

    [Test]
    public void Job_ThatDependsOnARead_SeesItsBytes()
    {
        IoThreads.Pause(true);
        ReadHandle read = Read(m_path, Command(0, FileBytes, 0));
        using var sum = new NativeReference<long>(Allocator.Persistent);
        JobHandle job = new SumBytesJob { Bytes = m_buffer, Sum = sum }.Schedule(read.JobHandle);
        Assert.That(job.IsCompleted, Is.False);
        IoThreads.Pause(false);
        job.Complete();
        Assert.That(sum.Value, Is.EqualTo(m_bytes.Sum(b => (long)b)));
        read.Dispose();
    }

    [Test]
    public void OpenFile_ManyReadsInFlight_ReadCorrectly()
    {
        FileHandle file = AsyncReadManager.OpenFileAsync(m_path);
        const int reads = 100;
        using var commands = new NativeArray<ReadCommand>(reads, Allocator.Persistent);
        var handles = new ReadHandle[reads];
        ReadCommand* first = (ReadCommand*)commands.GetUnsafePtr();
        for (int i = 0; i < reads; i++)
        {
            first[i] = Command(i * 1000, 1000, i * 1000);
            handles[i] = AsyncReadManager.Read(file, new ReadCommandArray { ReadCommands = first + i, CommandCount = 1 });
        }
        // The reads that were begun still get their bytes.
        JobHandle closed = file.Close();
        foreach (ReadHandle read in handles)
        {
            read.JobHandle.Complete();
            Assert.That(read.Status, Is.EqualTo(ReadStatus.Complete));
            read.Dispose();
        }
        closed.Complete();
        Assert.That(file.IsValid(), Is.False);
        Assert.That(() => AsyncReadManager.Read(file, default), Throws.InvalidOperationException);
        Assert.That(m_buffer.GetSubArray(0, FileBytes).ToArray(), Is.EqualTo(m_bytes));
    }

    [Test]
    public void ReadDeferred_CommandsWrittenByAJob_AreRead()
    {
        FileHandle file = AsyncReadManager.OpenFileAsync(m_path);
        var array = new NativeArray<ReadCommandArray>(1, Allocator.Persistent);
        array[0] = new ReadCommandArray { ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(), CommandCount = 1 };
        var arrayPointer = (ReadCommandArray*)array.GetUnsafePtr();
        m_commands[0] = Command(0, 0, 0);
        JobHandle written = new WriteCommandJob { Commands = m_commands, Offset = 5, Size = 5 }.Schedule(file.JobHandle);
        ReadHandle read = AsyncReadManager.ReadDeferred(file, arrayPointer, written);
        System.Threading.Thread.Sleep(30);
        Assert.That((int)read.Status, Is.EqualTo(3), "nobody has flushed the job");
        read.JobHandle.Complete();
        written.Complete();
        Assert.That(read.Status, Is.EqualTo(ReadStatus.Complete));
        Assert.That(m_buffer.GetSubArray(0, 5).ToArray(), Is.EqualTo(m_bytes.Skip(5).Take(5)));
        read.Dispose();
        file.Close().Complete();
        array.Dispose();
    }

    [Test]
    public void ReadDeferred_AfterAJobThatDoesNotWaitForTheFile_Fails()
    {
        IoThreads.Pause(true);
        FileHandle file = AsyncReadManager.OpenFileAsync(m_path);
        m_commands[0] = Command(0, 5, 0);
        using var array = new NativeArray<ReadCommandArray>(1, Allocator.Persistent);
        var pointer = (ReadCommandArray*)array.GetUnsafePtr();
        *pointer = new ReadCommandArray { ReadCommands = (ReadCommand*)m_commands.GetUnsafePtr(), CommandCount = 1 };
        ReadHandle read = AsyncReadManager.ReadDeferred(file, pointer, default);
        read.JobHandle.Complete();
        Assert.That(read.Status, Is.EqualTo(ReadStatus.Failed));
        read.Dispose();
        IoThreads.Pause(false);
        file.Close().Complete();
    }
}

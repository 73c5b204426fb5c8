namespace FastPoints.HostTests.Writing;

public sealed class FolderLockTests : ScratchPerTest
{
    string m_path;

    [SetUp]
    public void NamePaths() => m_path = Path.Combine(Scratch["PointClouds"], "imports.lock");

    static (int, long) Dead()
    {
        using var process = Process.Start(new ProcessStartInfo("dotnet", "--version") { RedirectStandardOutput = true });
        var dead = (process.Id, process.StartTime.ToUniversalTime().Ticks);
        process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        return dead;
    }

    [Test]
    public void TakeOrGetOwner_WhileItIsHeld_ReportsTheOwner()
    {
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var first), Is.Null);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, "else", (1, 1), out var second),
            Is.EqualTo("process " + Environment.ProcessId + " on " + Environment.MachineName));
        Assert.That(second, Is.Null);

        first.Dispose();
        Assert.That(File.Exists(m_path), Is.False);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out second), Is.Null);
        second.Dispose();
    }

    [Test]
    public void TakeOrGetOwner_CrashedOwner_IsReplaced()
    {
        FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, Dead(), out var crashed);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);

        crashed.Dispose();
        Assert.That(File.Exists(m_path), Is.True, "it is not its own any more");
        Assert.That(crashed.Renew(DateTime.UtcNow + FolderLock.RenewAfter), Is.False);
        Assert.That(next.Renew(DateTime.UtcNow + FolderLock.RenewAfter), Is.True);
        next.Dispose();
        Assert.That(Directory.GetFileSystemEntries(Scratch["PointClouds"]), Is.Empty);
    }

    [Test]
    public void TakeOrGetOwner_OwnerKilledAsItTookIt_IsReplacedAtOnce([Values(0, 3)] int written)
    {
        FolderLock.TakeOrGetOwner(m_path, out _);
        File.WriteAllText(m_path, File.ReadAllText(m_path)[..written]);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);
        next.Dispose();
    }

    [Test]
    public void TakeOrGetOwner_KilledAsItReplacedOne_IsReplacedAtOnce()
    {
        FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, Dead(), out _);
        FolderLock.TakeOrGetOwner(m_path + ".taking", Environment.MachineName, Dead(), out _);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);
        next.Dispose();
        Assert.That(Directory.GetFileSystemEntries(Scratch["PointClouds"]), Is.Empty);
    }

    [Test]
    public void TakeOrGetOwner_OwnerThatIsStillTakingIt_IsAwaited()
    {
        FolderLock.TakeOrGetOwner(m_path, "far", (7, 1), out _);
        string owner = File.ReadAllText(m_path);
        File.WriteAllText(m_path, "");
        int reads = 0;
        using var completing = WindowsRules.Hear((change, path, _) =>
        {
            if (path == m_path && change == FileChange.Open && reads++ == 2)
                File.WriteAllText(path, owner);
        });
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out _), Is.EqualTo("process 7 on far"));
    }

    [Test]
    public void TakeOrGetOwner_HeldUpUntilAnotherReplacedIt_IsNotTaken()
    {
        int reads = 0;
        using var replacing = WindowsRules.Hear((change, path, to) =>
        {
            if (path != m_path || change != FileChange.Open || reads++ > 0)
                return;
            File.Delete(path);
            FolderLock.TakeOrGetOwner(path, "far", (7, 1), out _);
        });
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var taken), Is.EqualTo("process 7 on far"));
        Assert.That(taken, Is.Null);
    }

    [Test]
    public void TakeOrGetOwner_ProcessIdReused_IsReplaced()
    {
        var (id, began) = FolderLock.Self();
        FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, (id, began - TimeSpan.TicksPerHour), out _);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);
        next.Dispose();
    }

    [Test]
    public void TakeOrGetOwner_LockOfAnEarlierDomainOfThisProcess_IsReplaced()
    {
        FolderLock.TakeOrGetOwner(m_path, out _);
        string[] lines = File.ReadAllText(m_path).Split('\n');
        lines[3] = "another load";
        File.WriteAllText(m_path, string.Join("\n", lines));

        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);
        next.Dispose();
    }

    // Its processes have numbers of their own.
    [Test]
    public void TakeOrGetOwner_LockOfAContainerOfTheSameMachine_IsReplacedWhenItIsNotRenewed()
    {
        FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, Dead(), out _);
        string[] lines = File.ReadAllText(m_path).Split('\n');
        lines[4] = "another root";
        File.WriteAllText(m_path, string.Join("\n", lines));

        Assert.That(FolderLock.TakeOrGetOwner(m_path, out _),
            Is.EqualTo("process " + lines[1] + " on " + Environment.MachineName));
        File.SetLastWriteTimeUtc(m_path, DateTime.UtcNow - FolderLock.StaleAfter - TimeSpan.FromSeconds(1));
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);
        next.Dispose();
    }

    [Test]
    public void TakeOrGetOwner_RuntimeWithoutProcessIds_ExcludesItselfAndReplacesAnEarlierLock()
    {
        var unknown = default((int, long));
        FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, unknown, out _);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, unknown, out _), Is.EqualTo("another process"));
        string[] lines = File.ReadAllText(m_path).Split('\n');
        lines[3] = "another run";
        File.WriteAllText(m_path, string.Join("\n", lines));

        Assert.That(FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, unknown, out var next), Is.Null);
        next.Dispose();
    }

    [Test]
    public void Renew_UnreadableFile_IsKeptAndMissingOneIsNot()
    {
        FolderLock.TakeOrGetOwner(m_path, out var held);
        File.Delete(m_path);
        Assert.That(held.Renew(DateTime.UtcNow + FolderLock.RenewAfter), Is.False);

        FolderLock.TakeOrGetOwner(m_path, out held);
        using (new FileStream(m_path, FileMode.Open, FileAccess.ReadWrite, FileShare.None))
            Assert.That(held.Renew(DateTime.UtcNow + FolderLock.RenewAfter), Is.True);
        held.Dispose();
    }

    [Test]
    public void TakeOrGetOwner_SilentOwnerOnAnotherMachine_IsReplaced()
    {
        FolderLock.TakeOrGetOwner(m_path, "far", (7, 1), out var far);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out _), Is.EqualTo("process 7 on far"));

        File.SetLastWriteTimeUtc(m_path, DateTime.UtcNow - FolderLock.StaleAfter - TimeSpan.FromSeconds(1));
        Assert.That(far.Renew(DateTime.UtcNow + FolderLock.RenewAfter), Is.True);
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out _), Is.EqualTo("process 7 on far"), "it was renewed");

        File.SetLastWriteTimeUtc(m_path, DateTime.UtcNow - FolderLock.StaleAfter - TimeSpan.FromSeconds(1));
        Assert.That(FolderLock.TakeOrGetOwner(m_path, out var next), Is.Null);
        Assert.That(far.Renew(DateTime.UtcNow + 3 * FolderLock.RenewAfter), Is.False);
        next.Dispose();
    }

    [Test]
    public void TakeOrGetOwner_ManyAtOnce_OneHasIt()
    {
        var dead = Dead();
        for (int round = 0; round < 50; round++)
        {
            FolderLock.TakeOrGetOwner(m_path, Environment.MachineName, dead, out _);
            var taken = new FolderLock[8];
            Parallel.For(0, taken.Length, i => FolderLock.TakeOrGetOwner(m_path, out taken[i]));
            Assert.That(taken.Count(t => t != null), Is.EqualTo(1));
            taken.Single(t => t != null).Dispose();
        }
        Assert.That(Directory.GetFileSystemEntries(Scratch["PointClouds"]), Is.Empty);
    }
}

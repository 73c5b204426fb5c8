using System;
using System.Diagnostics;
using System.IO;
using FastPoints.Cli;
using NUnit.Framework;

namespace FastPoints.HostTests.Cli
{
    /// <summary>What only a process of its own can show.</summary>
    public sealed class SignalTests
    {
        static Process Start(params string[] args)
        {
            string name = Path.Combine(AppContext.BaseDirectory, OperatingSystem.IsWindows() ? "FastPoints.Cli.exe" : "FastPoints.Cli");
            return Process.Start(new ProcessStartInfo(name, args) { RedirectStandardError = true, RedirectStandardOutput = true });
        }

        [TestCase("INT")]
        [TestCase("TERM")]
        [Platform(Exclude = "Win")]
        public void Signal_WhileWriting_EndsWith130AndLeavesNothing(string signal)
        {
            using var scratch = new ScratchFolder();
            using var process = Start("demo-cloud", "-o", scratch["big.las"], "--points", "400000000");
            // The first line of progress: the file is being written.
            string line = process.StandardError.ReadLine();
            Assert.That(line, Does.Contain("points/s"));
            Assert.That(Directory.GetFiles(scratch.Root), Is.Not.Empty);
            using (var kill = Process.Start("kill", new[] { "-" + signal, process.Id.ToString() }))
                kill.WaitForExit();
            string rest = process.StandardError.ReadToEnd();
            Assert.That(process.WaitForExit(20_000), Is.True);
            Assert.That(process.ExitCode, Is.EqualTo(ExitStatus.Cancelled), rest);
            Assert.That(rest, Does.EndWith("fastpoints: cancelled\n"));
            Assert.That(Directory.GetFiles(scratch.Root), Is.Empty);
        }
    }
}

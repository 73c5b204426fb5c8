using System.Collections.Generic;
using FastPoints.Store;
using NUnit.Framework;

namespace FastPoints.Tests.Store
{
    public class StoredSourcesTests : FolderTests
    {
        [Test]
        public void Read_SourcesOfACountry_HasThemAll()
        {
            const int count = 200_000;
            var sources = new List<SourceEntry>();
            for (int i = 0; i < count; i++)
                sources.Add(new SourceEntry
                {
                    Name = "tile_of_a_country_32_" + i + ".laz",
                    FileBytes = 40_000_000 + i,
                    Points = 10_000_000,
                    HeadHash = ulong.MaxValue,
                });
            Folder.Write(StoreFormat.SourcesName, StoredSources.ToJson(sources));
            var read = StoredSources.Read(Folder.Path);
            Assert.That(read.Count, Is.EqualTo(count));
            Assert.That(read[count - 1].FileBytes, Is.EqualTo(sources[count - 1].FileBytes));
        }
    }
}

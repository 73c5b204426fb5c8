using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Projects.BuiltIn
{
    /// <summary>All that the package's tests say of this project, they say of this pipeline.</summary>
    [Category("Smoke")]
    public sealed class PipelineTests
    {
        [Test]
        public void Pipeline_OfThisProject_IsTheBuiltInOne() => Assert.That(GraphicsSettings.currentRenderPipeline, Is.Null);

        [Test]
        public void Colour_OfThisProject_IsLinear() => Assert.That(PlayerSettings.colorSpace, Is.EqualTo(ColorSpace.Linear));
    }
}

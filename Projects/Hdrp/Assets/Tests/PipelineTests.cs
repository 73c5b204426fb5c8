using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.HighDefinition;

namespace FastPoints.Projects.Hdrp
{
    /// <summary>All that the package's tests say of this project, they say of this pipeline.</summary>
    [Category("Smoke")]
    public sealed class PipelineTests
    {
        [Test]
        public void Pipeline_OfThisProject_IsHdrps() =>
            Assert.That(GraphicsSettings.currentRenderPipeline, Is.TypeOf<HDRenderPipelineAsset>());

        [Test]
        public void Colour_OfThisProject_IsLinear() => Assert.That(PlayerSettings.colorSpace, Is.EqualTo(ColorSpace.Linear));
    }
}

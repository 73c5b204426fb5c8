using UnityEditor.UnityLinker;

namespace UnityEditor.UnityLinker
{
    public sealed class UnityLinkerBuildPipelineData
    {
        public UnityLinkerBuildPipelineData(BuildTarget target, string inputDirectory) { }
    }
}

namespace UnityEditor.Build
{
    public interface IUnityLinkerProcessor : IOrderedCallback
    {
        string GenerateAdditionalLinkXmlFile(BuildReport report, UnityLinkerBuildPipelineData data);
    }
}

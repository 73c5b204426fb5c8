Shader "Hidden/FastPoints/Points"
{
    SubShader
    {
        Pass
        {
            Name "Points"
            ZWrite On
            ZTest LEqual
            Cull Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma require setrtarrayindexfromanyshader : FASTPOINTS_STEREO
            #pragma vertex FastPointsVertex
            #pragma fragment FastPointsFragment
            #pragma multi_compile_local _ FASTPOINTS_SQUARES FASTPOINTS_DISCS FASTPOINTS_PARABOLOIDS
            #pragma multi_compile_local _ FASTPOINTS_ADAPTIVE
            #pragma multi_compile_local _ FASTPOINTS_LAYERED FASTPOINTS_STEREO
            #pragma multi_compile_local _ FASTPOINTS_CLIPPED
            #pragma multi_compile_local _ FASTPOINTS_FILTERED
            #include "Packages/com.fastpoints.dots/Shaders/PointPass.hlsl"
            ENDHLSL
        }

        // What the first pass drew, once more: added up where it is near the nearest.
        Pass
        {
            Name "Blending"
            ZWrite Off
            ZTest LEqual
            Cull Off
            Blend One One

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex FastPointsVertex
            #pragma fragment FastPointsFragment
            #pragma multi_compile_local _ FASTPOINTS_ADAPTIVE
            #pragma multi_compile_local _ FASTPOINTS_CLIPPED
            #pragma multi_compile_local _ FASTPOINTS_FILTERED
            #define FASTPOINTS_BLENDING
            #include "Packages/com.fastpoints.dots/Shaders/PointPass.hlsl"
            ENDHLSL
        }

        // Into a layer, with the number of the point that each pixel shows. Without clip boxes, or hidden classes, these cost a
        // comparison.
        Pass
        {
            Name "Progressive"
            ZWrite On
            ZTest LEqual
            Cull Off

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex FastPointsVertex
            #pragma fragment FastPointsFragment
            #pragma multi_compile_local _ FASTPOINTS_SQUARES FASTPOINTS_DISCS FASTPOINTS_PARABOLOIDS
            #pragma multi_compile_local _ FASTPOINTS_ADAPTIVE
            #define FASTPOINTS_PROGRESSIVE
            #define FASTPOINTS_CLIPPED
            #define FASTPOINTS_FILTERED
            #include "Packages/com.fastpoints.dots/Shaders/PointPass.hlsl"
            ENDHLSL
        }
    }
}
